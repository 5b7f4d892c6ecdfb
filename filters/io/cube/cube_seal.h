// The checksum of a baked probe's file, over all its bytes, so that damage anywhere is detected. Internal to this
// folder.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <string>

namespace boxprobe {

/// Reserves space for the checksum in the header of part 0: the text attribute "checksum".
void addSeal(Imf::Header& header);
/// Fills in the checksum: XXH3, 128 bits, as 32 hexadecimal digits, computed with zeros in their place.
void seal(std::string& bytes);

enum class Seal { None, Whole, Broken };
/// Checks a file's bytes. None: written by a version without checksums, or by another program.
Seal checkSeal(std::string bytes);

}  // namespace boxprobe
