// The table of analytic cases: one row is one render that has an exact answer.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "tests/render/exact.hpp"

namespace sg::truth {

struct Layer {
    int uv = 0;
    bool from_vertex = false;  // tangents
    int height = 0;            // which of the two height functions
    glm::dvec2 tiling{1};
    double strength = 1;
    // The texture.
    bool two_channels = false;
    bool green_up = true;
    double zero = 127.5;
    bool float_texels = false;  // else 16 bits
};

enum class Eye {
    front,
    behind,
    inside,
    far,
    facing
};  // facing: straight on and orthographic, for the mip case
// All but none turn and move. turned: uniform scale 2; mirrored: of negative determinant; squashed: not
// uniform, along the axis of the sphere and the torus, so that their parameter lines stay perpendicular.
enum class Placement { none, turned, mirrored, squashed };

struct Case {
    std::string name;
    Shape shape = Shape::plane;
    std::vector<Layer> layers;
    Unwrap unwrap = Unwrap::straight;
    Eye eye = Eye::front;
    bool orthographic = false;
    Placement placement = Placement::none;
    Side two_sided = Side::front;  // front: off
    bool tangents_made = false;    // by the runtime from uv0, instead of the shape's exact ones
    int mip_level = 0;             // the coarsest level that is read; 0: the texture has no other
};

inline std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

const std::vector<Case>& all_cases();
const Case& case_named(const std::string& name);

// The bump of one layer of a case, as calculus sees it.
Bump bump_of(const Case& c, const Layer& layer);

}  // namespace sg::truth
