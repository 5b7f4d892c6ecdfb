# Run as a script: writes OUTPUT, a C++ file with the text of every FILE under ROOT. Raw literals are cut into pieces
# because compilers limit their length.
file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/*.glsl")
list(SORT files)
set(text "// Generated from shaders/ by shaders/embed.cmake.\n#include \"filters/math/shared/shader_source.h\"\n\n#include <cstdio>\n#include <cstdlib>\n#include <string>\n\nnamespace boxprobe {\n\nstd::string_view shaderSource(std::string_view name) {\n")
foreach(file IN LISTS files)
  file(READ "${ROOT}/${file}" source)
  string(APPEND text "  if (name == \"${file}\") return R\"GLSL_SOURCE(${source})GLSL_SOURCE\";\n")
endforeach()
string(APPEND text "  std::fprintf(stderr, \"no shader file %s\\n\", std::string(name).c_str());\n  std::abort();\n}\n\n}  // namespace boxprobe\n")
file(WRITE "${OUTPUT}" "${text}")
