// The text of every file under shaders/, compiled into the program, so that it runs from anywhere.
#pragma once

#include <string_view>

namespace boxprobe {

/// `name`: path below shaders/, e.g. "shared/slab.glsl". An unknown name is a programming error: aborts and prints it.
std::string_view shaderSource(std::string_view name);

}  // namespace boxprobe
