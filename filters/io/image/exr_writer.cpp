#include "filters/io/image/exr_writer.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/atomic_file.h"

namespace boxprobe {

namespace {

constexpr int kZipLevel = 2;

class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(std::string& bytes) : Imf::OStream("memory"), bytes_(bytes) {}
  void write(const char data[], int size) override {
    const auto count = static_cast<std::size_t>(size);
    if (position_ + count > bytes_.size()) bytes_.resize(position_ + count);
    std::copy(data, data + count, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += count;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }

 private:
  std::string& bytes_;
  std::size_t position_ = 0;
};

/// OpenEXR takes a mutable pointer for both directions; writing only reads from it.
Imf::FrameBuffer frameBuffer(const ExrLevel& level) {
  const Imath::Box2i window({0, 0}, {level.width - 1, level.height - 1});
  Imf::FrameBuffer buffer;
  for (const ExrPlane& plane : level.planes) {
    const bool isHalf = !plane.halves.empty();
    const void* values = isHalf ? static_cast<const void*>(plane.halves.data()) : plane.floats.data();
    buffer.insert(plane.channel, Imf::Slice::Make(isHalf ? Imf::HALF : Imf::FLOAT, const_cast<void*>(values), window));
  }
  return buffer;
}

void completeHeader(ExrPart& part) {
  for (const ExrPlane& plane : part.levels.front().planes) {
    part.header.channels().insert(plane.channel, Imf::Channel(plane.halves.empty() ? Imf::FLOAT : Imf::HALF));
  }
  part.header.setType(part.header.hasTileDescription() ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
}

void writePart(Imf::MultiPartOutputFile& file, int index, const ExrPart& part) {
  if (!part.header.hasTileDescription()) {
    Imf::OutputPart out(file, index);
    out.setFrameBuffer(frameBuffer(part.levels.front()));
    out.writePixels(part.levels.front().height);
    return;
  }
  Imf::TiledOutputPart out(file, index);
  for (int level = 0; level < out.numLevels(); ++level) {
    out.setFrameBuffer(frameBuffer(part.levels.at(static_cast<std::size_t>(level))));
    out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
  }
}

/// Bands of rows spread over the height, one in the middle of each cube face: as high as the blocks of both
/// compressions, and quick to compress.
ExrLevel sampleRows(const ExrLevel& level) {
  constexpr int kBands = 6, kBandRows = 32;
  if (level.height <= kBands * kBandRows) return level;
  ExrLevel sample{level.width, kBands * kBandRows, {}};
  const auto width = static_cast<std::ptrdiff_t>(level.width);
  const auto bands = [&](const auto& from, auto& to) {
    if (from.empty()) return;
    for (int band = 0; band < kBands; ++band) {
      const std::ptrdiff_t row = std::ptrdiff_t(level.height) * (2 * band + 1) / (2 * kBands) - kBandRows / 2;
      to.insert(to.end(), from.begin() + row * width, from.begin() + (row + kBandRows) * width);
    }
  };
  for (const ExrPlane& plane : level.planes) {
    sample.planes.push_back({plane.channel, {}, {}});
    bands(plane.halves, sample.planes.back().halves);
    bands(plane.floats, sample.planes.back().floats);
  }
  return sample;
}

// Conversion would turn values beyond half's range into infinity, which later programs spread over the picture.
half toHalf(float value) {
  return half(std::clamp(value, -static_cast<float>(HALF_MAX), static_cast<float>(HALF_MAX)));
}

}  // namespace

ExrPart exrPart(int width, int height) {
  ExrPart part{Imf::Header(width, height), {}};
  part.levels.push_back({width, height, {}});
  return part;
}

void addPlane(ExrLevel& level, const std::string& channel, const float* values, std::size_t stride,
              ExrPrecision precision) {
  ExrPlane plane{channel, {}, {}};
  const std::size_t count = static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
  if (precision == ExrPrecision::Half) {
    plane.halves.resize(count);
    for (std::size_t i = 0; i < count; ++i) plane.halves[i] = toHalf(values[i * stride]);
  } else {
    plane.floats.resize(count);
    for (std::size_t i = 0; i < count; ++i) plane.floats[i] = values[i * stride];
  }
  level.planes.push_back(std::move(plane));
}

void addRgba(ExrLevel& level, const float* pixels, ExrPrecision precision) {
  const char* const names[4] = {"R", "G", "B", "A"};
  for (std::size_t c = 0; c < 4; ++c) addPlane(level, names[c], pixels + c, 4, precision);
}

Imf::Compression chooseCompression(const ExrLevel& level) {
  const auto bytes = [&level](Imf::Compression compression) {
    ExrPart part = exrPart(level.width, 1);
    part.levels = {sampleRows(level)};
    const ExrLevel& sample = part.levels.front();
    part.header = Imf::Header(sample.width, sample.height);
    part.header.compression() = compression;
    return encodeExr({std::move(part)}).size();
  };
  const std::size_t zip = bytes(Imf::ZIP_COMPRESSION), piz = bytes(Imf::PIZ_COMPRESSION);
  return piz < zip ? Imf::PIZ_COMPRESSION : Imf::ZIP_COMPRESSION;
}

std::string encodeExr(std::vector<ExrPart> parts) {
  // OpenEXR's default level, 4, takes nearly twice the time for little gain.
  Imf::setDefaultZipCompressionLevel(kZipLevel);
  std::vector<Imf::Header> headers;
  for (ExrPart& part : parts) {
    completeHeader(part);
    headers.push_back(part.header);
  }
  std::string bytes;
  {
    MemoryStream stream(bytes);
    Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) writePart(file, static_cast<int>(i), parts[i]);
  }  // the offset tables are written when the file goes out of scope
  return bytes;
}

void saveExrParts(const std::string& path, std::vector<ExrPart> parts,
                  const std::function<void(std::string&)>& complete) {
  std::string bytes;
  try {
    bytes = encodeExr(std::move(parts));
  } catch (const std::exception& problem) {
    throw WorkError(path + ": cannot be written: " + oneLine(problem.what()));
  }
  if (complete) complete(bytes);
  writeTextAtomically(path, bytes);
}

}  // namespace boxprobe
