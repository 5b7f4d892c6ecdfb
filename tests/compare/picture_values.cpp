// See picture_values.h.
#include "tests/compare/picture_values.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>

namespace boxprobe::compare {

namespace {

constexpr double kLeastShare = 0.01;  // smaller values are compared as if they were this share of the plane's largest

/// Memory for every channel of a level, and what OpenEXR writes into it.
Imf::FrameBuffer frameBuffer(const Imf::Header& header, const Imath::Box2i& window, const std::string& place,
                             PictureValues& picture) {
  const auto width = static_cast<std::size_t>(window.max.x - window.min.x) + 1;
  const auto height = static_cast<std::size_t>(window.max.y - window.min.y) + 1;
  Imf::FrameBuffer buffer;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    std::vector<float>& plane = picture.planes[place + channel.name()];
    plane.assign(width * height, 0.0f);
    buffer.insert(channel.name(), Imf::Slice::Make(Imf::FLOAT, plane.data(), window));
  }
  return buffer;
}

void readPart(Imf::MultiPartInputFile& file, int number, PictureValues& picture) {
  const Imf::Header& header = file.header(number);
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    picture.attributes.insert(attribute.name());
  }
  const std::string part = std::to_string(number) + "/";
  if (!header.hasTileDescription()) {
    const Imath::Box2i window = header.dataWindow();
    Imf::InputPart input(file, number);
    input.setFrameBuffer(frameBuffer(header, window, part + "0/", picture));
    input.readPixels(window.min.y, window.max.y);
    return;
  }
  Imf::TiledInputPart input(file, number);
  for (int level = 0; level < std::min(input.numXLevels(), input.numYLevels()); ++level) {
    const std::string place = part + std::to_string(level) + "/";
    input.setFrameBuffer(frameBuffer(header, input.dataWindowForLevel(level, level), place, picture));
    input.readTiles(0, input.numXTiles(level) - 1, 0, input.numYTiles(level) - 1, level, level);
  }
}

PictureValues readExr(const std::string& path) {
  PictureValues picture;
  Imf::MultiPartInputFile file(path.c_str());
  for (int part = 0; part < file.parts(); ++part) readPart(file, part, picture);
  return picture;
}

PictureValues readDisplay(const std::string& path) {
  int width = 0, height = 0, stored = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> bytes(stbi_load(path.c_str(), &width, &height, &stored, 4),
                                                        stbi_image_free);
  if (!bytes) throw std::runtime_error(path + ": cannot read this picture: " + stbi_failure_reason());
  PictureValues picture;
  picture.display = true;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    std::vector<float>& plane = picture.planes[std::string("0/0/") + "RGBA"[channel]];
    plane.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) plane[i] = bytes.get()[4 * i + channel];
  }
  return picture;
}

double distance(float before, float after, double least) {
  if (before == after || (std::isnan(before) && std::isnan(after))) return 0.0;
  if (!std::isfinite(before) || !std::isfinite(after)) return std::numeric_limits<double>::infinity();
  const double a = before, b = after;
  return std::abs(a - b) / std::max({std::abs(a), std::abs(b), least});
}

/// The smallest denominator of a relative difference.
double leastMagnitude(const std::vector<float>& plane) {
  double largest = std::numeric_limits<float>::min();
  for (const float value : plane) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
  }
  return kLeastShare * largest;
}

}  // namespace

bool isPictureName(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".png" || extension == ".jpg" || extension == ".exr";
}

PictureValues readPicture(const std::string& path) {
  return std::filesystem::path(path).extension() == ".exr" ? readExr(path) : readDisplay(path);
}

PictureDifference difference(const PictureValues& before, const PictureValues& after) {
  PictureDifference result;
  for (const std::string& attribute : before.attributes) {
    if (after.attributes.count(attribute) == 0) result.missing.push_back("attribute " + attribute);
  }
  for (const auto& [name, old] : before.planes) {
    const auto found = after.planes.find(name);
    if (found == after.planes.end() || found->second.size() != old.size()) {
      result.missing.push_back("channel " + name + " of the same size");
      continue;
    }
    const double least = before.display ? 0.0 : leastMagnitude(old);
    for (std::size_t i = 0; i < old.size(); ++i) {
      const float fresh = found->second[i];
      const double here = before.display ? std::abs(old[i] - fresh) : distance(old[i], fresh, least);
      ++result.values;
      result.differing += here > 0.0 ? 1 : 0;
      result.largest = std::max(result.largest, here);
    }
  }
  return result;
}

}  // namespace boxprobe::compare
