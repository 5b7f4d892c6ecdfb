// The text of every file under data/web, compiled into the program: scripts and styles of pages.
#pragma once

#include <string_view>

namespace boxprobe {

/// `name` is the path below data/web. Asking for a file that does not exist is a mistake in the program: aborts with
/// the name.
std::string_view webSource(std::string_view name);

}  // namespace boxprobe
