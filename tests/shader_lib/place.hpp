// A place on a surface with everything that any producer of a surface gradient reads there, and what a change
// of its coordinates or of the viewport makes of it.
#pragma once

#include "draws.hpp"
#include "textures.hpp"

namespace sg::proof {

// What a producer may read, packed; the same for all.
enum At : std::size_t {
    kNormalAt = 0,  // and dpdx, dpdy: draw_frame
    kUvAt = 9,
    kDerivAt = 15,
    kScreenAt = 17,   // dH/dx, dH/dy
    kVectorAt = 19,   // a volume gradient, a place in a volume, or a normal
    kTangentAt = 22,  // vertex tangent and w
    kFactorAt = 26,
    kProjectorAt = 27,  // rows s, t, ahead and the place in the projector
    kSize = 39
};

// A place is what is looked up; the functions after it say what a change of coordinates or viewport makes of
// it. A turn by the angle a takes st to R st, so derivatives turn alike, and a vector towards +s becomes
// cos a T - sin a B.
inline constexpr const char* kPlaceGlsl = R"(
struct Place {
    SgFrame frame; SgUv uv; vec2 d; vec2 dh; vec3 v; vec4 tangent; mat4 projector; int image;
};
const float kCos = 0.5403023, kSin = 0.84147098;  // of 1 radian
mat4 projector_of(vec3 s, vec3 t, vec3 ahead, vec3 local) {
    return mat4(s.x, t.x, ahead.x, 0.0, s.y, t.y, ahead.y, 0.0, s.z, t.z, ahead.z, 0.0, local, 1.0);
}
Place place() {
    return Place(sg_frame(vec3(0.0), v3(3), v3(6), v3(0)), SgUv(v2(9), v2(11), v2(13)), v2(15), v2(17), v3(19), v4(22),
                 projector_of(v3(27), v3(30), v3(33), v3(36)), 0);
}
Place mirrored_u(Place p) {
    p.uv = SgUv(vec2(1.0 - p.uv.st.x, p.uv.st.y), p.uv.dx * vec2(-1.0, 1.0), p.uv.dy * vec2(-1.0, 1.0));
    p.d.x = -p.d.x, p.tangent = -p.tangent, p.image = 1;
    p.projector = projector_of(-v3(27), v3(30), v3(33), v3(36) * vec3(-1.0, 1.0, 1.0));
    return p;
}
Place mirrored_v(Place p) {
    p.uv = SgUv(vec2(p.uv.st.x, 1.0 - p.uv.st.y), p.uv.dx * vec2(1.0, -1.0), p.uv.dy * vec2(1.0, -1.0));
    p.d.y = -p.d.y, p.tangent.w = -p.tangent.w, p.image = 2;
    p.projector = projector_of(v3(27), -v3(30), v3(33), v3(36) * vec3(1.0, -1.0, 1.0));
    return p;
}
Place turned(Place p) {
    mat2 turn = mat2(kCos, kSin, -kSin, kCos);
    p.uv = SgUv(turn * (p.uv.st - 0.5) + 0.5, turn * p.uv.dx, turn * p.uv.dy);
    p.d = turn * p.d, p.image = 3;
    vec3 b = p.tangent.w * cross(p.frame.normal, p.tangent.xyz);
    p.tangent.xyz = kCos * p.tangent.xyz - kSin * b;
    p.projector = projector_of(kCos * v3(27) - kSin * v3(30), kSin * v3(27) + kCos * v3(30), v3(33),
                               vec3(turn * v2(36), f(38)));
    return p;
}
Place viewport_turned(Place p) {
    p.frame = sg_frame(vec3(0.0), v3(3), -v3(6), v3(0));
    p.uv.dy = -p.uv.dy, p.dh.y = -p.dh.y;
    return p;
}
)";

// The four textures hold one ramp: as it is, mirrored in u, in v, and turned.
inline constexpr const char* kLookupsGlsl = R"(
#define PICK(function, p) (p.image == 0 ? function(image_0, sampler_0, p.uv) : \
                          (p.image == 1 ? function(image_1, sampler_1, p.uv) : \
                          (p.image == 2 ? function(image_2, sampler_2, p.uv) : function(image_3, sampler_3, p.uv))))
)";
inline constexpr glm::dvec2 kRamp(1.0 / 128.0, -1.0 / 256.0);  // heights per texel
inline constexpr int kTexels = 64;
std::vector<std::shared_ptr<const CaseTexture>> ramp_of_places();

// General, or with coordinates that keep angles.
void draw_place(Random& random, Draw& in, bool conformal);
// Frames that no mesh should have but some will: steps along the normal, along each other, of sizes that do
// not go together; else anything that a register can hold. n is unit, d stays within its limit, a texture
// coordinate within its texture.
void draw_anywhere(Random& random, Draw& in);

}  // namespace sg::proof
