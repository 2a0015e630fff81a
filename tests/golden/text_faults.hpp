// What no generated GLSL text may have. Each gives a fault as text, or "".
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace sg::test {

// A local that is declared and then read once, without being one of `known` (or such a name with a number
// behind it). A derivative over the screen may stand in a local of its own in a text with parallax or an
// alpha test.
std::string local_used_once(std::string_view glsl, const std::set<std::string>& known);

// A call with arguments of their own that is written twice. A texture's size is no computation.
std::string computed_twice(std::string_view glsl);

// A comment between statements that the text has twice.
std::string comment_twice(std::string_view glsl);

// A local of one of these layers ("m_wall", "m_wall_uv") outside of the lines under that layer's comment.
std::string scattered_layer(std::string_view glsl, const std::set<std::string>& layers,
                            const std::set<std::string>& nodes);

// A local whose name says the same twice: "m_wall_wall_uv".
std::string stuttering_name(std::string_view glsl);

// A layer that no comment names. `layers`: as in the comments, "wall: noise".
std::string unnamed_layer(std::string_view glsl, const std::set<std::string>& layers);

// A line of more than 120 letters.
std::string long_line(std::string_view glsl);

// x + 0, 1 x, 0 - x, -1 x, a mix by 0 or 1, a frame on its own normal and the like; and -0.
std::string idle_arithmetic(std::string_view glsl);

}  // namespace sg::test
