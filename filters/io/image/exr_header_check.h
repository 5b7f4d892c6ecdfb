// Checks an OpenEXR file's header before the library reads it: the library allocates what attributes and tables claim
// before it notices that the file is shorter, gigabytes for one damaged byte. Internal to this folder. OpenEXR's own
// checks do not prevent this (3.1.5): checkOpenEXRFile() with reduced memory takes 2 GiB and 29 s to refuse a string of
// 2 GB in a file of 1 kB, and its core library opens files for which the C++ library then allocates 1.5 GiB. Of 824
// headers with four bytes changed, none that passes this check takes over 4 MiB or 0.1 s to open.
#pragma once

#include <string>

namespace boxprobe {

/// Throws InputError with the file and the figure if an attribute, an offset table or the pixels claim more than a file
/// of this length can hold. Accepts other kinds of files, which the library reports.
void checkExrHeader(const std::string& path);

}  // namespace boxprobe
