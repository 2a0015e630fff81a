// What the library declares, read from its text.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace sg::proof {

// Every file of shader_lib/surfgrad/ and lighting/, as include names ("surfgrad/uv.glsl"), sorted.
std::vector<std::string> library_files();

// Function name -> the file that defines it, for every file above. Overloads share a name.
std::map<std::string, std::string> library_functions();

// The doc comment above the first definition of a function: the `//` lines that touch it.
std::string doc_comment(const std::string& file, const std::string& function);

// The first definition of a function, from its type to its closing brace; "" if the file does not define it.
std::string definition(const std::string& file, const std::string& function);

}  // namespace sg::proof
