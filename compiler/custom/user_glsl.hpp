// A user's GLSL file: what it declares, what it may not do, and its text under names that collide with
// nothing. What may stand in one: functions, structs and constants; includes of the library; the directives
// of conditions and macros. What it says beyond that (types, values) is for a compiler to check.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "custom/tokens.hpp"

namespace sg::custom {

// A function as declared: "vec3 dents(SgFrame, float)".
struct Declaration {
    std::string name;
    std::string result;
    std::vector<std::string> parameters;  // types, with "out" or "inout" in front where it stands
    Span span;                            // of the name
};
std::string signature(std::string_view result, std::string_view name,
                      std::span<const std::string> parameters);

struct UserGlsl {
    std::vector<Fault> faults;
    std::vector<Declaration> functions;  // with a body
    std::vector<std::string> names;      // everything that it declares outside functions, macros too
    std::vector<Token> tokens;
    std::vector<std::uint32_t> members;  // where names of structs' members begin; they keep their names
};

// `library`: what may be included. `text` must outlive the result.
UserGlsl scan(std::string_view text, std::span<const std::string_view> library);

// The text with a prefix in front of its own `names` and of `defines`; the same lines, and one more in front
// of each token whose number is among `breaks`, which ascend.
std::string prefixed(std::string_view text, const UserGlsl& scanned, std::span<const std::string> defines,
                     std::string_view prefix, std::span<const std::size_t> breaks = {});

// A macro of the command line: "" or what is wrong with it.
std::string define_fault(std::string_view name, std::string_view value);

}  // namespace sg::custom
