// A look at an OpenEXR file's header before the library's: it allocates what attributes and tables say they hold before
// it notices that the file is shorter, gigabytes for one damaged byte. Internal to this folder.
#pragma once

#include <string>

namespace boxprobe {

/// Throws InputError naming the file and the figure if an attribute, an offset table or the pixels promise more than a
/// file of this length can hold. Says nothing about files of another kind; the library does.
void checkExrHeader(const std::string& path);

}  // namespace boxprobe
