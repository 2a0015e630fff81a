// The text form of a module, line by line ('#' starts a comment that reaches to the end of the line):
//
//   module "brick"
//   lighting phong                    a lighting model that is not the default
//   texture 0 "scan" tangent_normal
//   parameter 0 "detail" : Scalar 0 4     the range of each component, where there is one
//   host %0 = parameter 0 : Scalar    computed before drawing, from parameters alone
//   derived 0 "twice" : Scalar = %0   (or "= %0 positive") what the host hands over beside them
//   shader 0 "dents.glsl"             a file of the user's GLSL, without its text
//   function 0 "dents" 0 Uv texture 0 of a shader, with its arguments
//   %0 = position : Position
//   layer "scan" normal_map           values from here on belong to this layer
//   layer "wood" noise in "floor"     likewise, within a group
//   %1 = uv_set 0 : Uv                attribute Set
//   %2 = sample 0 %1 : Texel 'texel'  attribute Texture, operands, a name hint
//   %3 = decode_normal_xyz 127.5 %2 : TangentNormal
//   %4 = constant 0.5 : Scalar        attribute Number, as many as the type has
//   %5 = add %4 %4 : Scalar "wear"    the name of a node of the material
//   layer none
//   output normal = %9
//   output uv 0 = %1
//   output layer "scan" normal_map = %8
//
// Names are quoted with \" \\ and \xNN escapes. Numbers print with the fewest digits that read back equal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diag.hpp"
#include "ir/ir.hpp"

namespace sg::ir {

// Reads the text form. A fault gives nothing and says in `fault` which line and why. The result is not
// verified.
std::optional<Module> parse(std::string_view text, std::string& fault);

// Reads the text form and verifies it; each fault is an error at its statement.
std::optional<Module> read(const SourcePtr& source, Diags& diags);

}  // namespace sg::ir
