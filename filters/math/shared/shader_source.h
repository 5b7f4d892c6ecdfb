// The text of every file under shaders/, compiled into the program, so that it runs from anywhere.
#pragma once

#include <string_view>

namespace boxprobe {

/// `name` is the path below shaders/, e.g. "shared/slab.glsl". Asking for a file that does not exist is a mistake in
/// the program: aborts with the name.
std::string_view shaderSource(std::string_view name);

}  // namespace boxprobe
