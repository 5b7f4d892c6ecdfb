// OpenEXR files of one or several parts, flat or mip-mapped, composed in memory and written whole. Internal to this
// folder. Through memory because OpenEXR's own file output swallows what fails while a file is closed: a full disk
// would leave a broken file and no error.
#pragma once

#include <Imath/half.h>
#include <OpenEXR/ImfHeader.h>

#include <functional>
#include <string>
#include <vector>

#include "filters/io/image/exr_precision.h"

namespace boxprobe {

/// One channel's values, rows from the top: `halves` or `floats`.
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
  std::vector<ExrLevel> levels;  ///< one, or as many as the header's tile description asks for
};

/// A part of scan lines without channels yet, one level.
ExrPart exrPart(int width, int height);

/// `stride` floats lie from one pixel's value to the next one's.
void addPlane(ExrLevel& level, const std::string& channel, const float* values, std::size_t stride,
              ExrPrecision precision);
/// Planes R, G, B and A from interleaved pixels.
void addRgba(ExrLevel& level, const float* pixels, ExrPrecision precision);

/// ZIP or PIZ, whichever makes rows spread over the level smaller: even areas and smooth gradients, as rendered, favour
/// ZIP, grain favours the wavelets of PIZ. Both lose nothing and take about the same time.
Imf::Compression chooseCompression(const ExrLevel& level);

/// The file's bytes. Channels of each header are those of its levels' planes.
std::string encodeExr(std::vector<ExrPart> parts);
/// The same into a temporary file, renamed to `path`. Throws WorkError.
/// `complete` may change bytes of it first.
void saveExrParts(const std::string& path, std::vector<ExrPart> parts,
                  const std::function<void(std::string&)>& complete = {});

}  // namespace boxprobe
