// See picture_shares.h. A band is an OpenEXR picture twice as high as its rows: colours above, standard errors below.
#include "app/cli/farm/picture_shares.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "filters/core/base/errors.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

std::size_t rowsBefore(int height, int index, int count) {
  return static_cast<std::size_t>(static_cast<std::int64_t>(height) * index / count);
}

}  // namespace

PicturePart rowsOfShare(int width, int height, const BakeShare& share) {
  return {0, static_cast<int>(rowsBefore(height, share.index - 1, share.count)), width,
          static_cast<int>(rowsBefore(height, share.index, share.count))};
}

std::string bandPath(const std::string& picture, const BakeShare& share, const std::string& key) {
  return picture + "." + std::to_string(share.index) + "-of-" + std::to_string(share.count) + "." + key + ".band.exr";
}

void saveBand(const std::string& path, const ReferencePicture& picture, const PicturePart& part) {
  const std::size_t row = 4 * static_cast<std::size_t>(picture.color.width);
  ImageRgbaF band{picture.color.width, 2 * (part.bottom - part.top), {}};
  for (const ImageRgbaF* image : {&picture.color, &picture.standardError}) {
    const auto from = image->pixels.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(part.top));
    const auto to = image->pixels.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(part.bottom));
    band.pixels.insert(band.pixels.end(), from, to);
  }
  saveExr(path, band);
}

JoinedBands joinBands(const std::string& picture, int width, int height, int shares, const std::string& key) {
  JoinedBands joined;
  for (int i = 1; i <= shares; ++i) {
    const PicturePart part = rowsOfShare(width, height, {i, shares});
    if (part.top < part.bottom && !std::filesystem::exists(bandPath(picture, {i, shares}, key))) ++joined.missing;
  }
  if (joined.missing > 0) return joined;
  joined.picture.color = joined.picture.standardError = {width, height, {}};
  for (int i = 1; i <= shares; ++i) {
    const PicturePart part = rowsOfShare(width, height, {i, shares});
    const int rows = part.bottom - part.top;
    if (rows == 0) continue;
    const std::string path = bandPath(picture, {i, shares}, key);
    ImageRgbaF band;
    try {
      band = loadHdrImage(path);
    } catch (const InputError&) {
      joined.elsewhere = !std::filesystem::exists(path);
      if (!joined.elsewhere) throw;
      return joined;
    }
    if (band.width != width || band.height != 2 * rows) {
      throw InputError(path + ": not the band that its name says; delete it and run its share again");
    }
    const auto half = band.pixels.begin() + static_cast<std::ptrdiff_t>(band.pixels.size() / 2);
    joined.picture.color.pixels.insert(joined.picture.color.pixels.end(), band.pixels.begin(), half);
    joined.picture.standardError.pixels.insert(joined.picture.standardError.pixels.end(), half, band.pixels.end());
  }
  return joined;
}

void removeBands(const std::string& picture, int shares, const std::string& key) {
  for (int i = 1; i <= shares; ++i) {
    std::error_code ignored;  // another process that saw all of them may have been sooner
    std::filesystem::remove(bandPath(picture, {i, shares}, key), ignored);
  }
}

}  // namespace boxprobe
