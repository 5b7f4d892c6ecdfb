// Writes OpenEXR files of one or several parts, flat or mip-mapped. They are composed in memory, because OpenEXR's own
// file output ignores errors while a file is closed: a full disk would leave a broken file and no error. Internal to
// this folder.
#pragma once

#include <Imath/half.h>
#include <OpenEXR/ImfHeader.h>

#include <functional>
#include <string>
#include <vector>

#include "filters/io/image/exr_precision.h"

namespace boxprobe {

/// One channel's values, rows from the top: either `halves` or `floats`.
struct ExrPlane {
  std::string channel;
  std::vector<half> halves;
  std::vector<float> floats;
};

struct ExrLevel {
  int width = 0;
  int height = 0;
  std::vector<ExrPlane> planes;
};

struct ExrPart {
  Imf::Header header;
  std::vector<ExrLevel> levels;  ///< one, or as many as the header's tile description requires
};

/// A single-level scan-line part, still without channels.
ExrPart exrPart(int width, int height);

/// `stride`: floats from one pixel's value to the next.
void addPlane(ExrLevel& level, const std::string& channel, const float* values, std::size_t stride,
              ExrPrecision precision);
/// Planes R, G, B and A from interleaved pixels.
void addRgba(ExrLevel& level, const float* pixels, ExrPrecision precision);

/// ZIP or PIZ, whichever compresses sample rows of the level better: rendered areas and gradients favour ZIP, grain
/// favours PIZ's wavelets. Both are lossless and take about the same time.
Imf::Compression chooseCompression(const ExrLevel& level);

/// The file's bytes. The channels of each header are those of its levels' planes.
std::string encodeExr(std::vector<ExrPart> parts);
/// The same into a temporary file, renamed to `path`. `complete` may modify the bytes first. Throws WorkError.
void saveExrParts(const std::string& path, std::vector<ExrPart> parts,
                  const std::function<void(std::string&)>& complete = {});

}  // namespace boxprobe
