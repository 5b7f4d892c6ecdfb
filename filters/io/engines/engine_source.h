// The text of every file under data/engines, compiled into the program, so that it runs from anywhere.
#pragma once

#include <string_view>

namespace boxprobe {

/// `name`: path below data/engines. An unknown name is a programming error: aborts and prints it.
std::string_view engineSource(std::string_view name);

}  // namespace boxprobe
