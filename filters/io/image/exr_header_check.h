// A look at an OpenEXR file's header before the library's: it allocates what attributes and tables say they hold before
// it notices that the file is shorter, gigabytes for one damaged byte. Internal to this folder. OpenEXR's own checks do
// not hold it (3.1.5): checkOpenEXRFile() with reduced memory takes 2 GiB and 29 s to refuse a string of 2 GB in a file
// of 1 kB, and its core library opens what the C++ one then allocates 1.5 GiB for. Of 824 headers with four bytes
// changed, this check lets none take over 4 MiB or 0.1 s to open.
#pragma once

#include <string>

namespace boxprobe {

/// Throws InputError naming the file and the figure if an attribute, an offset table or the pixels promise more than a
/// file of this length can hold. Says nothing about files of another kind; the library does.
void checkExrHeader(const std::string& path);

}  // namespace boxprobe
