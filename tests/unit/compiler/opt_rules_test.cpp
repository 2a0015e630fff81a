// Each rule of the optimiser: text before and after.
#include <set>

#include "tests/unit/compiler/opt_text.hpp"

namespace sg::opt {
namespace {

// Text before and after; the rule that does it must be the one named: without it the text differs.
struct RuleCase {
    std::string_view rule;
    std::string_view before;
    std::string_view after;
};

const RuleCase kCases[] = {
    {"scale_by_one",
     "%8 = constant 1 : Scalar\n%9 = scale_deriv %8 %7 : Deriv\n%10 = surfgrad_from_tbn %9 %3 : "
     "SurfGrad\n"
     "%11 = scale_surfgrad %8 %10 : SurfGrad\noutput gradient = %11\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"channel_by_its_name", "%8 = swizzle 27 %5 : Texel\n%9 = channel 0 %8 : Scalar\noutput metallic = %9\n",
     "%0 = uv_set 0 : Uv\n%1 = sample 0 %0 : Texel\n%2 = channel 3 %1 : Scalar\noutput metallic = %2\n"},
    {"scale_to_nothing",
     "%8 = constant 0 : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = position : Position\n"
     "%11 = frame %10 %1 : Frame\n%12 = basis_uv %11 %4 : Basis\n%13 = surfgrad_from_tbn %7 %12 : SurfGrad\n"
     "%14 = add_surfgrad %9 %13 : SurfGrad\n%15 = scale_surfgrad %8 %14 : SurfGrad\noutput gradient = "
     "%15\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"scale_before_projection",
     "%8 = facing : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = scale_surfgrad %8 %9 : "
     "SurfGrad\n"
     "output gradient = %10\n",
     "%7 = facing : Scalar\n%8 = scale_deriv %7 %6 : Deriv\n%9 = surfgrad_from_tbn %8 %2 : "
     "SurfGrad\noutput gradient = %9\n"},
    {"mask_is_a_factor",
     "%8 = constant 1 : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = mask_surfgrad %9 %8 : "
     "SurfGrad\n"
     "output gradient = %10\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"mask_is_a_factor",
     "%8 = constant 0 : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = mask_surfgrad %9 %8 : "
     "SurfGrad\n"
     "output gradient = %10\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"trivial_mix",
     "%8 = constant 1 : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = zero_surfgrad : SurfGrad\n"
     "%11 = mix_surfgrad %10 %9 %8 : SurfGrad\noutput gradient = %11\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"mask_is_a_factor",
     "%8 = position : Position\n%9 = frame %8 %1 : Frame\n%10 = basis_uv %9 %4 : Basis\n%11 = facing : "
     "Scalar\n"
     "%12 = surfgrad_from_tbn %7 %10 : SurfGrad\n%13 = mask_surfgrad %12 %11 : SurfGrad\noutput gradient = "
     "%13\n",
     "%10 = constant 0 : Scalar\n%11 = constant 1 : Scalar\n%12 = clamp %9 %10 %11 : Scalar\n"
     "%13 = scale_deriv %12 %5 : Deriv\n%14 = surfgrad_from_tbn %13 %8 : SurfGrad\noutput gradient = %14\n"},
    {"number_is_within",
     "%8 = facing : Scalar\n%9 = smoothstep %8 %8 %8 : Scalar\n%10 = constant 0 : Scalar\n%11 = constant 1 : "
     "Scalar\n%12 = clamp %9 %10 %11 : Scalar\noutput metallic = %12\n",
     "%0 = facing : Scalar\n%1 = smoothstep %0 %0 %0 : Scalar\noutput metallic = %1\n"},
    {"one_factor",
     "%8 = facing : Scalar\n%9 = time : Scalar\n%10 = scale_deriv %8 %7 : Deriv\n%11 = scale_deriv %9 %10 : "
     "Deriv\n"
     "%12 = surfgrad_from_tbn %11 %3 : SurfGrad\noutput gradient = %12\n",
     "%9 = multiply %8 %7 : Scalar\n%10 = scale_deriv %9 %6 : Deriv\n%11 = surfgrad_from_tbn %10 %2 : "
     "SurfGrad\n"
     "output gradient = %11\n"},
    {"scale_before_turn",
     "%8 = volume_object : Volume\n%9 = noise_perlin %8 : Noise\n%10 = facing : Scalar\n%11 = time : Scalar\n"
     "%12 = noise_gradient %10 %9 : LocalGrad\n%13 = gradient_from_object %12 : VolGrad\n"
     "%14 = scale_volgrad %11 %13 : VolGrad\n%15 = surfgrad_from_volume %1 %14 : SurfGrad\noutput gradient = "
     "%15\n",
     "%6 = multiply %5 %4 : Scalar\n%7 = noise_gradient %6 %3 : LocalGrad\n%8 = gradient_from_object %7 : "
     "VolGrad\n"
     "%9 = surfgrad_from_volume %1 %8 : SurfGrad\noutput gradient = %9\n"},
    {"project_and_resolve",
     "%8 = volume_world : Volume\n%9 = noise_perlin %8 : Noise\n%10 = facing : Scalar\n"
     "%11 = noise_gradient %10 %9 : LocalGrad\n%12 = gradient_from_world %11 : VolGrad\n"
     "%13 = surfgrad_from_volume %1 %12 : SurfGrad\n%14 = resolve %1 %13 : Normal\noutput normal = %14\n",
     "%7 = resolve_volume %1 %6 : Normal\noutput normal = %7\n"},
    {"resolve_towards_normal",
     "%8 = facing : Scalar\n%9 = flip %1 %8 : Normal\n%10 = direction_of %1 : Direction\n"
     "%11 = surfgrad_from_normal %9 %10 : SurfGrad\n%12 = mask_surfgrad %11 %8 : SurfGrad\n"
     "%13 = resolve %9 %12 : Normal\noutput normal = %13\n",
     "%7 = resolve_towards %3 %1 %6 : Normal\noutput normal = %7\n"},
    {"project_nothing",
     "%8 = volume_world : Volume\n%9 = noise_perlin %8 : Noise\n%10 = constant 0 : Scalar\n%11 = constant 3 "
     ": "
     "Scalar\n%12 = noise_gradient %11 %9 : LocalGrad\n%13 = gradient_from_world %12 : VolGrad\n"
     "%14 = scale_volgrad %10 %13 : VolGrad\n%15 = surfgrad_from_volume %1 %14 : SurfGrad\noutput gradient = "
     "%15\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"mix_before_projection",
     "%8 = volume_world : Volume\n%9 = noise_perlin %8 : Noise\n%10 = facing : Scalar\n%11 = time : "
     "Scalar\n"
     "%12 = noise_gradient %10 %9 : LocalGrad\n%13 = gradient_from_world %12 : VolGrad\n%14 = "
     "noise_gradient %11 %9 : LocalGrad\n"
     "%15 = gradient_from_world %14 : VolGrad\n%16 = surfgrad_from_volume %1 %13 : SurfGrad\n"
     "%17 = surfgrad_from_volume %1 %15 : SurfGrad\n%18 = mix_surfgrad %16 %17 %10 : SurfGrad\noutput "
     "gradient = %18\n",
     "%10 = mix_volgrad %7 %9 %4 : VolGrad\n%11 = surfgrad_from_volume %1 %10 : SurfGrad\noutput "
     "gradient = %11\n"},
    {"fold_numbers",
     "%8 = constant 2 : Scalar\n%9 = constant 3 : Scalar\n%10 = multiply %8 %9 : Scalar\n%11 = subtract "
     "%10 %8 : Scalar\n"
     "output metallic = %11\n",
     "%0 = constant 4 : Scalar\noutput metallic = %0\n"},
    // Colours and vectors too, by the interpreter: the mix is (1, 1, 1), the smooth step 0.5.
    {"fold_numbers",
     "%8 = constant 0.5 0.25 0 : Color\n%9 = constant 0.25 : Scalar\n%10 = grey %9 : Color\n"
     "%11 = add_color %8 %10 : Color\n%12 = constant 1.25 1.5 1.75 : Color\n%13 = constant 0.5 : Scalar\n"
     "%14 = mix_color %11 %12 %13 : Color\n%15 = constant 0 : Scalar\n%16 = constant 1 : Scalar\n"
     "%17 = smoothstep %15 %16 %13 : Scalar\n%18 = grey %17 : Color\n%19 = multiply_color %14 %18 : Color\n"
     "output base_color = %19\n",
     "%0 = constant 0.5 0.5 0.5 : Color\noutput base_color = %0\n"},
    {"neutral_number",
     "%8 = constant 1 1 1 : Color\n%9 = sample 0 %4 : Texel\n%10 = rgb %9 : Color\n%11 = multiply_color %10 "
     "%8 : Color\n%12 = constant 0 0 0 : Color\n%13 = add_color %12 %11 : Color\n%14 = facing : Scalar\n"
     "%15 = constant 0 : Scalar\n%16 = subtract %14 %15 : Scalar\n%17 = constant 1 : Scalar\n"
     "%18 = divide %16 %17 : Scalar\noutput base_color = %13\noutput metallic = %18\n",
     "%2 = rgb %1 : Color\n%3 = facing : Scalar\noutput base_color = %2\noutput metallic = %3\n"},
    // A decal under a mask of 0: nothing is left of its projector.
    {"times_nothing",
     "%8 = constant 1 0 0 : Vec3\n%9 = projector %8 %8 %8 %8 : Projector\n%10 = volume_world : Volume\n"
     "%11 = decal_box %9 %10 : Decal\n%12 = decal_gradient %7 %11 : LocalGrad\n"
     "%13 = gradient_from_world %12 : VolGrad\n%14 = surfgrad_from_volume %1 %13 : SurfGrad\n"
     "%15 = constant 0.2 : Scalar\n%16 = decal_falloff_box %11 %15 : Scalar\n%17 = constant 0 : Scalar\n"
     "%18 = decal_angle_fade %1 %8 %17 %15 : Scalar\n%19 = multiply %16 %18 : Scalar\n"
     "%20 = multiply %17 %19 : Scalar\n%21 = mask_surfgrad %14 %20 : SurfGrad\noutput gradient = %21\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"one_sided_mix",
     "%8 = constant 0 : Scalar\n%9 = facing : Scalar\n%10 = time : Scalar\n%11 = constant 1 : Scalar\n"
     "%12 = mix %9 %10 %8 : Scalar\n%13 = mix %10 %12 %11 : Scalar\n%14 = mix %13 %13 %10 : Scalar\n"
     "output metallic = %14\n",
     "%0 = facing : Scalar\noutput metallic = %0\n"},
    {"one_sided_mix",
     "%8 = facing : Scalar\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = mix_surfgrad %9 %9 %8 : SurfGrad\n"
     "output gradient = %10\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"lookup_by_one",
     "%8 = volume_world : Volume\n%9 = constant 1 : Scalar\n%10 = volume_scale %8 %9 : Volume\n"
     "%11 = height %10 : Scalar\n%12 = constant 1 1 : Vec2\n%13 = uv_scale %4 %12 : Uv\n"
     "%14 = sample 0 %13 : Texel\n%15 = channel 0 %14 : Scalar\noutput metallic = %11\noutput roughness = "
     "%15\n",
     "%0 = uv_set 0 : Uv\n%1 = sample 0 %0 : Texel\n%2 = volume_world : Volume\n%3 = height %2 : Scalar\n"
     "%4 = channel 0 %1 : Scalar\noutput metallic = %3\noutput roughness = %4\n"},
    {"frame_of_its_normal",
     "%8 = position : Position\n%9 = frame %8 %1 : Frame\n%10 = frame_resolved %9 %1 : Frame\noutput frame = "
     "%10\n",
     "%2 = position : Position\n%3 = frame %2 %1 : Frame\noutput frame = %3\n"},
    {"neutral_number",
     "%8 = constant 1 : Scalar\n%9 = facing : Scalar\n%10 = multiply %8 %9 : Scalar\n%11 = constant 0 : "
     "Scalar\n"
     "%12 = add %10 %11 : Scalar\noutput metallic = %12\n",
     "%0 = facing : Scalar\noutput metallic = %0\n"},
    {"add_nothing",
     "%8 = zero_surfgrad : SurfGrad\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = add_surfgrad %8 %9 : "
     "SurfGrad\n"
     "%11 = add_surfgrad %10 %8 : SurfGrad\noutput gradient = %11\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"add_nothing",
     "%8 = constant 0 : Scalar\n%9 = scale_deriv %8 %7 : Deriv\n%10 = sample 0 %4 : Texel\n%11 = "
     "decode_normal_xy 127 %10 : TangentNormalXy\n%12 = deriv_from_normal_xy %11 : Deriv\n%13 = add_deriv %9 "
     "%12 : "
     "Deriv\n%14 = surfgrad_from_tbn %13 %3 : SurfGrad\noutput gradient = %14\n",
     "%6 = deriv_from_normal_xy %5 : Deriv\n%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"project_nothing",
     "%8 = constant 0 : Scalar\n%9 = scale_deriv %8 %7 : Deriv\n%10 = surfgrad_from_tbn %9 %3 : "
     "SurfGrad\noutput gradient = %10\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"no_way_to_itself",
     "%8 = direction_of %1 : Direction\n%9 = surfgrad_from_normal %1 %8 : SurfGrad\noutput gradient = %9\n",
     "%0 = zero_surfgrad : SurfGrad\noutput gradient = %0\n"},
    {"trivial_mix",
     "%8 = zero_surfgrad : SurfGrad\n%9 = surfgrad_from_tbn %7 %3 : SurfGrad\n%10 = facing : Scalar\n%11 = "
     "smoothstep %10 %10 %10 : Scalar\n%12 = mix_surfgrad %8 %9 %11 : SurfGrad\noutput gradient = %12\n",
     "%8 = smoothstep %7 %7 %7 : Scalar\n%9 = scale_deriv %8 %6 : Deriv\n%10 = surfgrad_from_tbn %9 %2 : "
     "SurfGrad\noutput gradient = %10\n"},
    {"resolve_nothing", "%8 = zero_surfgrad : SurfGrad\n%9 = resolve %1 %8 : Normal\noutput normal = %9\n",
     "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\noutput normal = %1\n"},
    {"one_vertex_map",
     "%8 = constant 2 : Scalar\n%9 = deriv_green_up %7 : Deriv\n%10 = scale_deriv %8 %9 : Deriv\n%11 = "
     "surfgrad_from_tbn %10 %3 : "
     "SurfGrad\n%12 = resolve %1 %11 : Normal\noutput normal = %12\n",
     "%5 = constant 1 : Scalar\n%6 = constant 2 -2 : Vec2\n%7 = resolve_vertex_map %0 %1 %5 %4 %6 : "
     "Normal\noutput normal = %7\n"},
    {"positive_tiling_shares_basis",
     "%8 = position : Position\n%9 = frame %8 %1 : Frame\n%10 = constant 2 3 : Vec2\n%11 = uv_scale %4 "
     "%10 : Uv\n"
     "%12 = basis_uv %9 %11 : Basis\n%13 = surfgrad_from_tbn %7 %12 : SurfGrad\noutput gradient = %13\n",
     "%8 = basis_uv %7 %2 : Basis\n%9 = surfgrad_from_tbn %5 %8 : SurfGrad\noutput gradient = %9\n"},
    {"positive_tiling_turns_nothing",
     "%8 = constant 2 3 : Vec2\n%9 = basis_mirror %3 %8 : Basis\n%10 = surfgrad_from_tbn %7 %9 : "
     "SurfGrad\n"
     "output gradient = %10\n",
     "%7 = surfgrad_from_tbn %6 %2 : SurfGrad\noutput gradient = %7\n"},
    {"one_projection",
     "%8 = constant 2 : Scalar\n%9 = scale_deriv %8 %7 : Deriv\n%10 = surfgrad_from_tbn %7 %3 : "
     "SurfGrad\n"
     "%11 = surfgrad_from_tbn %9 %3 : SurfGrad\n%12 = add_surfgrad %10 %11 : SurfGrad\noutput gradient = "
     "%12\n",
     "%9 = add_deriv %6 %8 : Deriv\n%10 = surfgrad_from_tbn %9 %2 : SurfGrad\noutput gradient = %10\n"},
    // The shader still needs the matrix for the coordinate.
    {"parallel_projection_has_one_gradient",
     "parameter 0 \"p\" : Projector\n%8 = parameter 0 : Projector\n%9 = volume_world : Volume\n"
     "%10 = decal_box %8 %9 : Decal\n%11 = decal_gradient %7 %10 : LocalGrad\n"
     "%12 = gradient_from_world %11 : VolGrad\n%13 = surfgrad_from_volume %1 %12 : SurfGrad\n"
     "%14 = decal_uv %10 : Uv\n%15 = sample 0 %14 : Texel\n%16 = channel 0 %15 : Scalar\n"
     "output gradient = %13\noutput metallic = %16\n",
     "host %0 = parameter 0 : Projector\nhost %1 = projector_axis 0 %0 : Vec3\n"
     "host %2 = unit %1 : Vec3 'axis_s'\n"
     "host %3 = projector_axis 1 %0 : Vec3\nhost %4 = unit %3 : Vec3 'axis_t'\n"
     "derived 0 \"axis_s\" : Vec3 = %2\nderived 1 \"axis_t\" : Vec3 = %4\n"
     "%0 = vertex_normal : VertexNormal\n"
     "%1 = base_normal %0 : Normal\n"
     "%2 = uv_set 0 : Uv\n"
     "%3 = sample 0 %2 : Texel\n"
     "%4 = decode_normal_xyz 127.5 %3 : TangentNormal\n"
     "%5 = deriv_from_normal_xyz %4 : Deriv\n"
     "%6 = parameter 0 : Projector\n"
     "%7 = volume_world : Volume\n"
     "%8 = decal_box %6 %7 : Decal\n"
     "%9 = derived 0 : Vec3 'axis_s'\n"
     "%10 = derived 1 : Vec3 'axis_t'\n"
     "%11 = decal_gradient_along %5 %9 %10 : LocalGrad\n"
     "%12 = gradient_from_world %11 : VolGrad\n"
     "%13 = surfgrad_from_volume %1 %12 : SurfGrad\n"
     "%14 = decal_uv %8 : Uv\n"
     "%15 = sample 0 %14 : Texel\n"
     "%16 = channel 0 %15 : Scalar\n"
     "output gradient = %13\n"
     "output metallic = %16\n"},
    {"drift_from_nowhere",
     "%8 = constant 0 0 : Vec2\n%9 = constant 0.5 2 : Vec2\n%10 = time : Scalar\n"
     "%11 = drift %8 %9 %10 : Vec2 'drift'\n%12 = uv_scale %4 %11 : Uv\n"
     "%13 = sample 0 %12 : Texel\n%14 = channel 0 %13 : Scalar\noutput metallic = %14\n",
     "%0 = uv_set 0 : Uv\n%1 = constant 0.5 2 : Vec2\n%2 = time : Scalar\n"
     "%3 = travel %2 %1 : Vec2 'drift'\n%4 = uv_scale %0 %3 : Uv\n%5 = sample 0 %4 : Texel\n"
     "%6 = channel 0 %5 : Scalar\noutput metallic = %6\n"},
    // %11 is needed by the shader and by %12; the channel alone costs nothing and stays.
    {"parameters_on_host",
     "parameter 0 \"p\" : Scalar\nparameter 1 \"q\" : Vec4\n%8 = parameter 0 : Scalar\n%9 = parameter 1 : "
     "Vec4\n"
     "%10 = channel_of 2 %9 : Scalar\n%11 = multiply %8 %10 : Scalar 'both'\n%12 = add %11 %11 : Scalar\n"
     "%13 = facing : Scalar\n%14 = multiply %13 %11 : Scalar\n%15 = multiply %12 %14 : Scalar\n"
     "output metallic = %15\noutput roughness = %10\noutput opacity = %8\n",
     "host %0 = parameter 0 : Scalar\nhost %1 = parameter 1 : Vec4\nhost %2 = channel_of 2 %1 : Scalar\n"
     "host %3 = multiply %0 %2 : Scalar 'both'\nhost %4 = add %3 %3 : Scalar\n"
     "derived 0 \"both\" : Scalar = %3\nderived 1 \"add\" : Scalar = %4\n"
     "%0 = parameter 0 : Scalar\n%1 = parameter 1 : Vec4\n%2 = channel_of 2 %1 : Scalar\n"
     "%3 = derived 0 : Scalar 'both'\n%4 = derived 1 : Scalar\n%5 = facing : Scalar\n"
     "%6 = multiply %5 %3 : Scalar\n%7 = multiply %4 %6 : Scalar\n"
     "output metallic = %7\noutput roughness = %2\noutput opacity = %0\n"},
};

TEST(Opt, EachRuleBeforeAndAfter) {
    std::set<std::string_view> seen;
    for (const RuleCase& c : kCases) {
        std::string before = kTexture + kSurface + std::string(c.before);
        std::string after = optimised(before);
        EXPECT_TRUE(after.ends_with(c.after)) << c.rule << ":\n" << after;
        EXPECT_NE(after, optimised(before, c.rule)) << c.rule << " does nothing here";
        seen.insert(c.rule);
    }
    for (const Rule& rule : all_rules()) {
        EXPECT_TRUE(seen.count(rule.name)) << "no case for the rule " << rule.name;
        EXPECT_FALSE(rule.reason.empty());
    }
}

}  // namespace
}  // namespace sg::opt
