// The checksum of a baked probe's file: one over all its bytes, so that no damage anywhere goes unseen. Used by the
// reader and the writer of baked probes. Internal to this folder.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <string>

namespace boxprobe {

/// Makes room for the checksum in the header of part 0: the text attribute "checksum".
void addSeal(Imf::Header& header);
/// Fills it in: XXH3, 128 bits, as 32 hexadecimal digits, of the file with zeros in their place.
void seal(std::string& bytes);

enum class Seal { None, Whole, Broken };
/// Of a file's bytes. None: by a version that wrote no checksum, or by another program.
Seal checkSeal(std::string bytes);

}  // namespace boxprobe
