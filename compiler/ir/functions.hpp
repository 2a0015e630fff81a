// The library's functions in double precision: ONE table, a row per function of shader_lib/surfgrad/ and
// lighting/, with the signature that the row's C++ types mean in GLSL. The interpreter's operations
// (evaluate_ops.cpp) and the proofs of the library evaluate the same functions; tests/shader_lib names a
// function without a row, or one whose signature differs.
#pragma once

#include <any>
#include <span>
#include <string>
#include <string_view>

namespace sg::ir {

struct LibraryFunction {
    std::string_view glsl;  // "sg_reject"
    std::string signature;  // "vec3(vec3, vec3)"
    std::any pointer;       // to a function of those types: std::any_cast<dvec3 (*)(dvec3, dvec3)>
};
std::span<const LibraryFunction> library_functions();
// Null if the library has no such function.
const LibraryFunction* library_function(std::string_view glsl);

}  // namespace sg::ir
