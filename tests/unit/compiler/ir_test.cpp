#include <gtest/gtest.h>

#include "ir/ir.hpp"
#include "ir/text.hpp"
#include "tests/support/golden.hpp"

namespace sg::ir {
namespace {

Module parsed(std::string_view text) {
    std::string fault;
    auto module = parse(text, fault);
    EXPECT_TRUE(module) << fault;
    return module.value_or(Module{});
}

constexpr std::string_view kWhole = R"(module "a \"b\" \x0a"
texture 0 "t \\ u" tangent_normal
texture 1 "xy" tangent_normal_xy
parameter 0 "p" : Scalar
parameter 1 "tint" : Color
%0 = uv_set 3 : Uv 'uv3'
%1 = vertex_normal : VertexNormal
layer "one's \"id\"" normal_map in "outer/\"inner\""
%2 = constant 2 -0.1 : Vec2
%3 = uv_scale %0 %2 : Uv 'uv'
%4 = sample 1 %3 : Texel
%5 = decode_normal_xy 127.5 %4 : TangentNormalXy
layer none
%6 = base_normal %1 : Normal
%7 = parameter 1 : Color
output normal = %6
output base_color = %7
output uv 3 = %0
)";

TEST(Ir, PrintsWhatItParses) {
    EXPECT_EQ(print(parsed(kWhole)), kWhole);
}
TEST(Ir, TheWholeExampleVerifies) {
    EXPECT_EQ(verify(parsed(kWhole)), "");
}

TEST(Ir, CommentsAndBlankLinesAreSkipped) {
    EXPECT_EQ(print(parsed("# head\n\nmodule \"m\"  # tail\n")), "module \"m\"\n");
}

struct FaultCase {
    std::string_view text;
    std::string_view fault;
};

TEST(Ir, ParserSaysWhichLineAndWhy) {
    const FaultCase cases[] = {
        {"modul \"a\"", "line 1: unknown statement 'modul'"},
        {"module \"a\"\n%1 = position : Position", "line 2: values must be numbered in order"},
        {"%0 = positon : Position", "line 1: unknown operation 'positon'"},
        {"%0 = position : Positon", "line 1: unknown type 'Positon'"},
        {"%0 = position : Position extra", "line 1: unexpected 'extra'"},
        {"%0 = constant 1 2 3 4 5 : Vec4", "line 1: a constant has at most 4 numbers"},
        {"%0 = constant one : Scalar", "line 1: expected a number before 'one : Scalar'"},
        {"output colour = %0", "line 1: unknown output 'colour'"},
        {"texture 0 \"a\" bumpy", "line 1: unknown encoding 'bumpy'"},
        {"texture 1 \"a\" tangent_normal", "line 1: textures must be numbered in order"},
        {"%0 position", "line 1: expected '=' before 'position'"},
        {"module \"a", "line 1: expected '\"' before ''"},
    };
    for (const FaultCase& c : cases) {
        std::string fault;
        EXPECT_FALSE(parse(c.text, fault)) << c.text;
        EXPECT_EQ(fault, c.fault);
    }
}

// The algebra: what may not be mixed is refused.
TEST(Ir, VerifierRefusesIllegalMixes) {
    constexpr std::string_view kHead =
        "texture 0 \"t\" tangent_normal\nparameter 0 \"p\" : Vec2\n"
        "%0 = uv_set 0 : Uv\n%1 = vertex_normal : VertexNormal\n%2 = base_normal %1 : Normal\n"
        "%3 = vertex_tangent : VertexTangent\n%4 = basis_vertex %1 %3 : Basis\n%5 = sample 0 %0 : Texel\n"
        "%6 = decode_normal_xyz 127.5 %5 : TangentNormal\n%7 = deriv_from_normal_xyz %6 : Deriv\n"
        "%8 = surfgrad_from_tbn %7 %4 : SurfGrad\n";
    const FaultCase cases[] = {
        {"%9 = add_surfgrad %8 %7 : SurfGrad",
         "%9: 'add_surfgrad' takes SurfGrad as operand 1, found Deriv (%7)\n"},
        {"%9 = resolve %2 %7 : Normal", "%9: 'resolve' takes SurfGrad as operand 1, found Deriv (%7)\n"},
        {"%9 = resolve %1 %8 : Normal", "%9: 'resolve' takes Normal as operand 0, found VertexNormal (%1)\n"},
        {"%9 = add_deriv %7 %8 : Deriv", "%9: 'add_deriv' takes Deriv as operand 1, found SurfGrad (%8)\n"},
        {"%9 = surfgrad_from_tbn %6 %4 : SurfGrad",
         "%9: 'surfgrad_from_tbn' takes Deriv as operand 0, found TangentNormal (%6)\n"},
        {"%9 = volume_world : Volume\n%10 = noise_perlin %9 : Noise\n%11 = constant 1 : Scalar\n"
         "%12 = noise_gradient %11 %10 : LocalGrad\n%13 = add_surfgrad %8 %12 : SurfGrad",
         "%13: 'add_surfgrad' takes SurfGrad as operand 1, found LocalGrad (%12)\n"},
        {"%9 = decode_normal_xyz 126 %5 : TangentNormal", "%9: zero 126 is not in 127..128\n"},
        {"%9 = uv_set 8 : Uv", "%9: uv set 8 is not in 0..7\n"},
        {"%9 = sample 1 %0 : Texel", "%9: no such texture\n"},
        {"%9 = parameter 1 : Scalar", "%9: no such parameter\n"},
        {"%9 = parameter 0 : Scalar", "%9: parameter 'p' is Vec2, the value is Scalar\n"},
        {"%9 = constant inf : Scalar", "%9: a constant is not finite\n"},
        {"%9 = constant 1 : SurfGrad", "%9: 'constant' cannot give SurfGrad\n"},
        {"%9 = position : Normal", "%9: 'position' gives Position, the value is Normal\n"},
        {"%9 = add_deriv %7 : Deriv", "%9: 'add_deriv' takes 2 operands, found 1\n"},
        {"%9 = add_deriv %9 %7 : Deriv", "%9: operand 0 is not an earlier value\n"},
        {"output normal = %8", "output normal: takes Normal, found SurfGrad (%8)\n"},
        {"output normal = %99", "output normal: no such value\n"},
        {"output normal = %2\noutput normal = %2", "output normal: is set twice\n"},
    };
    EXPECT_EQ(verify(parsed(kHead)), "");
    for (const FaultCase& c : cases)
        EXPECT_EQ(verify(parsed(std::string(kHead) + std::string(c.text))), c.fault);
}

std::string read_messages(const std::string& text) {
    Diags diags;
    const auto module = read(std::make_shared<Source>(Source{"wall.ir", text}), diags);
    EXPECT_EQ(module.has_value(), !diags.has_errors());
    return render(diags);
}

// A text module with such a mix is refused at the statement that makes it.
TEST(Ir, ReadingSaysWhereGradientsAreMixed) {
    const std::string head =
        "module \"wall\"\ntexture 0 \"t\" tangent_normal\n"
        "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\n"
        "%2 = vertex_tangent : VertexTangent\n%3 = basis_vertex %0 %2 : Basis\n%4 = uv_set 0 : Uv\n"
        "%5 = sample 0 %4 : Texel\n%6 = decode_normal_xyz 127.5 %5 : TangentNormal\n"
        "%7 = deriv_from_normal_xyz %6 : Deriv\n%8 = surfgrad_from_tbn %7 %3 : SurfGrad\n"
        "%9 = volume_object : Volume\n%10 = noise_perlin %9 : Noise\n%11 = constant 1 : Scalar\n"
        "%12 = noise_gradient %11 %10 : LocalGrad\n%13 = gradient_from_object %12 : VolGrad\n";
    EXPECT_EQ(read_messages(head), "");
    EXPECT_EQ(
        read_messages(head + "  %14 = add_surfgrad %8 %13 : SurfGrad\t'sum'  # no\n"
                             "%15 = resolve %1 %13 : Normal\noutput gradient = %13\n"),
        "wall.ir:17:3: error: 'add_surfgrad' takes SurfGrad as operand 1, found VolGrad (%13) [SG2112]\n"
        "  %14 = add_surfgrad %8 %13 : SurfGrad 'sum'  # no\n"
        "  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n"
        "    compile the material again with --emit ir; a text of your own: give the operation what it "
        "takes\n"
        "wall.ir:18:1: error: 'resolve' takes SurfGrad as operand 1, found VolGrad (%13) [SG2112]\n"
        "%15 = resolve %1 %13 : Normal\n"
        "^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n"
        "    compile the material again with --emit ir; a text of your own: give the operation what it "
        "takes\n"
        "wall.ir:19:1: error: takes SurfGrad, found VolGrad (%13) [SG2112]\n"
        "output gradient = %13\n"
        "^^^^^^^^^^^^^^^^^^^^^\n"
        "    compile the material again with --emit ir; a text of your own: give the operation what it "
        "takes\n");
    EXPECT_EQ(read_messages(head + "%14 = scale_surfgrad 1 %8 : SurfGrad\n"),
              "wall.ir:17:1: error: expected ':' before '1 %8 : SurfGrad' [SG2112]\n"
              "%14 = scale_surfgrad 1 %8 : SurfGrad\n"
              "^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n"
              "    compile the material again with --emit ir; a text of your own: give the operation what it "
              "takes\n");
}

TEST(Ir, ReadingSaysWhereDerivativesAreTakenBehindParallax) {
    const std::string head =
        "texture 0 \"t\" height\n%0 = position : Position\n%1 = vertex_normal : VertexNormal\n"
        "%2 = base_normal %1 : Normal\n%3 = frame %0 %2 : Frame\n%4 = uv_set 0 : Uv\n%5 = view %0 : View\n"
        "%6 = parallax_direction %3 %4 %5 : TextureView\n%7 = constant 0.1 -0.1 : Vec2\n"
        "%8 = constant 16 : Scalar\n%9 = parallax_occlusion 0 %4 %6 %7 %8 : Hit\n";
    EXPECT_EQ(read_messages(head + "%10 = uv_set 1 : Uv\n"),
              "wall.ir:12:1: error: 'uv_set' takes screen derivatives behind parallax ('parallax_occlusion', "
              "%9) [SG2112]\n%10 = uv_set 1 : Uv\n^^^^^^^^^^^^^^^^^^^\n"
              "    compile the material again with --emit ir; a text of your own: give the operation what it "
              "takes\n");
}

TEST(Ir, ReadingSaysWhichLineOfTheHostIsAtFault) {
    EXPECT_EQ(read_messages("parameter 0 \"p\" : Scalar\nhost %0 = facing : Scalar\n"
                            "derived 0 \"d\" : Scalar = %1\n%0 = derived 1 : Scalar\n"),
              "wall.ir:2:1: error: 'facing' is nothing that the host computes [SG2112]\n"
              "host %0 = facing : Scalar\n^^^^^^^^^^^^^^^^^^^^^^^^^\n"
              "    compile the material again with --emit ir; a text of your own: give the operation what it "
              "takes\n"
              "wall.ir:3:1: error: is no value of the host of its type [SG2112]\n"
              "derived 0 \"d\" : Scalar = %1\n^^^^^^^^^^^^^^^^^^^^^^^^^^^\n"
              "    compile the material again with --emit ir; a text of your own: give the operation what it "
              "takes\n"
              "wall.ir:4:1: error: no such derived number [SG2112]\n"
              "%0 = derived 1 : Scalar\n^^^^^^^^^^^^^^^^^^^^^^^\n"
              "    compile the material again with --emit ir; a text of your own: give the operation what it "
              "takes\n");
}

// Neighbouring pixels see other places: nothing behind parallax may be differenced over the screen.
TEST(Ir, VerifierRefusesScreenDerivativesBehindParallax) {
    constexpr std::string_view kHead =
        "texture 0 \"t\" height\n%0 = position : Position\n%1 = vertex_normal : VertexNormal\n"
        "%2 = base_normal %1 : Normal\n%3 = frame %0 %2 : Frame\n%4 = uv_set 0 : Uv\n%5 = view %0 : View\n"
        "%6 = parallax_direction %3 %4 %5 : TextureView\n%7 = constant 0.1 -0.1 : Vec2\n"
        "%8 = constant 16 : Scalar\n%9 = parallax_occlusion 0 %4 %6 %7 %8 : Hit\n";
    const std::string behind = " takes screen derivatives behind parallax ('parallax_occlusion', %9)\n";
    EXPECT_EQ(verify(parsed(kHead)), "");
    EXPECT_EQ(verify(parsed(std::string(kHead) + "%10 = uv_set 1 : Uv")), "%10: 'uv_set'" + behind);
    EXPECT_EQ(verify(parsed(std::string(kHead) + "%10 = volume_world : Volume")),
              "%10: 'volume_world'" + behind);
    EXPECT_EQ(verify(parsed(std::string(kHead) + "%10 = normal_derivatives %1 : NormalDerivatives")),
              "%10: 'normal_derivatives'" + behind);
    EXPECT_EQ(verify(parsed(std::string(kHead) +
                            "%10 = hit_offset %9 : Offset\n%11 = hit_height %9 : Scalar\n"
                            "%12 = parallax_pixels %4 %10 : Pixels\n"
                            "%13 = parallax_position %3 %12 %11 : Position\n%14 = frame %13 %2 : Frame")),
              "%14: 'frame'" + behind);
}

// The flag of an operation is what its GLSL does.
TEST(Ir, ScreenDerivativesAreTakenWhereTheFlagSaysSo) {
    for (const OpInfo& op : all_ops()) {
        bool takes = false;
        if (op.include == "stage/fragment.glsl" || op.include == "stage/world.glsl") {
            const std::string stage =
                test::read_file(test::source_dir() / "shader_lib" / std::string(op.include));
            const std::size_t begin = stage.find(op.glsl.substr(0, op.glsl.find('(') + 1));
            ASSERT_NE(begin, stage.npos) << op.name;
            const std::string body = stage.substr(begin, stage.find('}', begin) - begin);
            takes = body.find("dFd") != body.npos || body.find("sg_stage_volume(") != body.npos;
        }
        EXPECT_EQ(takes_screen_derivatives(op.op), takes) << op.name;
    }
}

TEST(Ir, EveryRowIsWhole) {
    for (const OpInfo& op : all_ops()) {
        EXPECT_FALSE(op.meaning.empty()) << op.name;
        EXPECT_FALSE(op.glsl.empty()) << op.name;
        for (std::size_t i = 0; i < op.operands.size(); ++i) {
            EXPECT_NE(op.glsl.find("{" + std::to_string(i) + "}"), std::string_view::npos)
                << op.name << " drops an operand";
        }
        bool calls = op.glsl.find("sg_") == 0 && op.glsl.find("sg_in_") != 0;
        EXPECT_EQ(calls, !op.include.empty()) << op.name;
    }
    for (Output output : all_outputs()) EXPECT_FALSE(output_name(output).empty());
}

}  // namespace
}  // namespace sg::ir
