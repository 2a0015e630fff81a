// Names for generated text. What `unique` gives:
//   * is a valid identifier in GLSL, ESSL, HLSL and Metal: [a-z]_ as prefix, then letters, digits, single
//   '_';
//   * cannot be a keyword of any of them, nor collide with the library (which uses sg_, Sg and SG_);
//   * differs from every other name of the same Names, also where users' names differ only in other
//   characters;
//   * is the same for the same calls in the same order.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace sg::emit {

class Names {
public:
    std::string unique(std::string_view prefix, std::string_view wanted);

private:
    // By name: the number to try next behind it, where it is wanted again; all smaller ones are taken.
    std::map<std::string, int> taken_;
};

// Text for a '//' comment: one line, printable, without a trailing backslash, which would continue the line.
std::string comment_text(std::string_view text);

// The shortest GLSL literal that reads back as the same 32-bit float: "0.5", "1.0", "1e-07".
std::string float_literal(double value);

}  // namespace sg::emit
