// The text of every file under data/engines, compiled into the program, so that it runs from anywhere.
#pragma once

#include <string_view>

namespace boxprobe {

/// `name` is the path below data/engines. Asking for a file that does not exist is a mistake in the program: aborts
/// with the name.
std::string_view engineSource(std::string_view name);

}  // namespace boxprobe
