// OpenEXR in and out. Written as float RGBA, ZIP, scan lines; read through the general input part, which takes scan
// lines and tiles, half and float alike and converts to float.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <filesystem>

#include "filters/core/errors.h"
#include "filters/core/one_line.h"
#include "filters/io/atomic_file.h"
#include "filters/io/image_detail.h"
#include "filters/io/image_file.h"

namespace boxprobe {

namespace {

constexpr std::size_t kPixelBytes = 4 * sizeof(float);
const char* const kChannelNames[4] = {"R", "G", "B", "A"};

/// Which stored channel fills each of R, G, B, A; null where none does.
struct ChannelPlan {
  const char* source[4] = {nullptr, nullptr, nullptr, nullptr};
};

ChannelPlan planChannels(const Imf::ChannelList& channels, const std::string& path) {
  ChannelPlan plan;
  if (channels.findChannel("A") != nullptr) plan.source[3] = "A";
  const bool color = channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B");
  if (color) {
    for (int i = 0; i < 3; ++i) plan.source[i] = kChannelNames[i];
  } else if (channels.findChannel("Y") != nullptr && channels.findChannel("RY") == nullptr) {
    plan.source[0] = "Y";  // grey: copied to green and blue once read
  } else {
    std::string names;
    for (auto it = channels.begin(); it != channels.end(); ++it)
      names += std::string(names.empty() ? "" : ", ") + it.name();
    throw InputError(path + ": part 0 has the channels " + (names.empty() ? "(none)" : names) +
                     "; R, G and B, or Y alone, are needed");
  }
  for (const char* source : plan.source) {
    if (source == nullptr) continue;
    const Imf::Channel& channel = channels[source];
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      throw InputError(path + ": part 0: channel " + source + " is subsampled; save it at full resolution");
    }
  }
  return plan;
}

ImageRgbaF readPart(Imf::MultiPartInputFile& file, const std::string& path) {
  if (file.parts() < 1) throw InputError(path + ": has no parts; save it again");
  if (file.header(0).hasType() && !Imf::isImage(file.header(0).type())) {
    throw InputError(path + ": part 0 is deep data (" + file.header(0).type() + "); flatten it first");
  }
  Imf::InputPart part(file, 0);
  const Imath::Box2i window = part.header().dataWindow();
  const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
  const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
  checkImageSize(path, width, height);
  const ChannelPlan plan = planChannels(part.header().channels(), path);

  ImageRgbaF image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.pixels.assign(static_cast<std::size_t>(width * height) * 4, 0.0f);
  Imf::FrameBuffer buffer;
  for (int i = 0; i < 4; ++i) {
    if (plan.source[i] == nullptr) continue;
    buffer.insert(plan.source[i], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + i, window, kPixelBytes,
                                                   kPixelBytes * image.width));
  }
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  for (std::size_t texel = 0; texel < image.pixels.size(); texel += 4) {
    if (plan.source[1] == nullptr) image.pixels[texel + 1] = image.pixels[texel + 2] = image.pixels[texel];
    if (plan.source[3] == nullptr) image.pixels[texel + 3] = 1.0f;
  }
  return image;
}

}  // namespace

ImageRgbaF loadExr(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path + ": does not exist; check the path");
  try {
    Imf::MultiPartInputFile file(path.c_str());
    return readPart(file, path);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    throw InputError(path + ": is not an OpenEXR picture, or is damaged (" + oneLine(problem.what()) +
                     "); save it again");
  }
}

void saveExr(const std::string& path, const ImageRgbaF& image) {
  checkPixelCount(path, image.width, image.height, image.pixels.size());
  writeAtomically(path, [&](const std::string& temporary) {
    try {
      Imf::Header header(image.width, image.height);
      header.compression() = Imf::ZIP_COMPRESSION;
      Imf::FrameBuffer buffer;
      const Imath::Box2i window = header.dataWindow();
      for (int i = 0; i < 4; ++i) {
        header.channels().insert(kChannelNames[i], Imf::Channel(Imf::FLOAT));
        // OpenEXR takes a mutable pointer for reading and writing alike; writing a file only reads it.
        buffer.insert(kChannelNames[i], Imf::Slice::Make(Imf::FLOAT, const_cast<float*>(image.pixels.data()) + i,
                                                         window, kPixelBytes, kPixelBytes * image.width));
      }
      Imf::OutputFile file(temporary.c_str(), header);
      file.setFrameBuffer(buffer);
      file.writePixels(image.height);
    } catch (const std::exception& problem) {
      throw WorkError(path + ": cannot be written: " + oneLine(problem.what()));
    }
  });
}

}  // namespace boxprobe
