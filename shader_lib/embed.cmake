# cmake -DROOT=dir "-DFILES=a.glsl;b.glsl" -DOUT=x.cpp -P embed.cmake
set(text "// Made by shader_lib/embed.cmake from the files of shader_lib.\n#include \"target/shader_library.hpp\"\n\n")
string(APPEND text "namespace sg::target {\n\nShaderLibrary embedded_library() {\n    ShaderLibrary library;\n")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} body)
  string(APPEND text "    library.files[\"${file}\"] = R\"SGLIB(${body})SGLIB\";\n")
endforeach()
string(APPEND text "    return library;\n}\n\n}  // namespace sg::target\n")
file(WRITE ${OUT} "${text}")
