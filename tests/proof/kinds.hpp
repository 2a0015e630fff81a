// One material per kind of bump whose heights are known: a strength "$h" scales all of its heights.
#pragma once

#include "tests/proof/subject.hpp"

namespace sg::proof {

using Texel = std::function<ref::dvec4(ref::dvec2)>;

struct KindCase {
    std::string name;
    runtime::SmoothShape shape = runtime::SmoothShape::torus;
    std::string material;                    // JSON without "parameters" and the closing brace
    std::map<std::string, Texel> textures;   // by name
    std::map<std::string, double> partners;  // textures of slopes: the world length of their heights' value 1
    double unit = 1;                         // what "$h" is per unit of world height
    bool decal = false;                      // its texture needs the projector (see made_subject)
    Texel (*stretched)(glm::dvec3) = nullptr;  // of slopes on a uv set: "map" where the axes are stretched
    std::string drawn;  // a material without known heights that must look like `material`; else itself
};
const std::vector<KindCase>& all_kind_cases();
// Kinds that have no height: blends of two normals, functions of one's own.
const std::vector<KindCase>& equal_kind_cases();
// Texels per side of a FunctionTexture.
inline constexpr double kFunctionSide = 1 << 18;
inline std::ostream& operator<<(std::ostream& out, const KindCase& c) {
    return out << c.name;
}

// The height that all textures stand for, period 1: world units per "$h".
double test_height(ref::dvec2 c);

// What its textures hold, by name, so that the heights are the same on a shape whose axes are stretched.
std::map<std::string, Texel> textures_of(const KindCase& c, glm::dvec3 stretch = glm::dvec3(1));
// json: the material, where it is not the case's own with the strength 1.
Subject made_subject(const KindCase& c, const std::string& json = "");

}  // namespace sg::proof
