#include "filters/io/cube/cube_source.h"

#include <algorithm>
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/cube/picture_repair.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_detail.h"
#include "filters/io/image/radiance_reader.h"

namespace boxprobe {

namespace {

/// The texels as stored, before any repair.
ExrPicture readPicture(const std::string& path, const PictureCode& code) {
  const std::string extension = lowerExtension(path);
  const bool linear = code.encoding == ImageEncoding::Linear;
  ExrPicture picture;
  if (linear && extension == ".exr") {
    withExrFile(path,
                [&](Imf::MultiPartInputFile& file) { picture = readExrPart(file, picturePart(file, path), path); });
    return picture;
  }
  if (!linear) {
    picture.image = loadEncodedImage(path, code);
  } else if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") {
    throw InputError(
        path +
        ": has eight bits, which hold no radiance as it is; say how they are to be read with \"encoding\": "
        "\"rgbm\", \"dldr\" or \"rgbmLinear\", or use an EXR or HDR picture");
  } else if (extension == ".hdr") {
    RadiancePicture radiance = decodeRadiance(readWholeFile(path), path);
    picture.image = std::move(radiance.image);
    picture.remarks = std::move(radiance.remarks);
  } else {
    throw InputError(path + ": has an extension that is not read; use .exr or .hdr");
  }
  picture.displayWidth = picture.image.width;
  picture.displayHeight = picture.image.height;
  return picture;
}

}  // namespace

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

CubeSource readCubeSource(const std::string& path, const PictureCode& code) {
  CubeSource source;
  source.path = path;
  source.picture = readPicture(path, code);
  ExrPicture& picture = source.picture;
  source.repairs.remarks = std::move(picture.remarks);
  // Before colours are converted, which mixes channels.
  repairNotFinite(picture.image, layoutOfShape(picture.image.width, picture.image.height) == CubeLayout::LatLong,
                  source.repairs);
  convertToRec709(picture);
  limitRadiance(picture.image, source.repairs);
  for (float& distance : picture.distance) {
    if (!std::isfinite(distance) || distance < 0.0f) distance = 0.0f;
  }
  return source;
}

CubeLayout layoutOfShape(long long width, long long height) {
  if (width == 2 * height) return CubeLayout::LatLong;
  if (width == 6 * height || height == 6 * width) return CubeLayout::Strip;
  if (3 * width == 4 * height && width % 4 == 0) return CubeLayout::Cross;
  if (4 * width == 3 * height && width % 3 == 0) return CubeLayout::Cross;
  return CubeLayout::Automatic;
}

// A writer may have omitted black borders or rendered overscan.
void fillDisplayWindow(CubeSource& source) {
  ExrPicture& picture = source.picture;
  const bool same = picture.displayWidth == picture.image.width && picture.displayHeight == picture.image.height &&
                    picture.offsetX == 0 && picture.offsetY == 0;
  if (same) return;
  checkImageSize(source.path, picture.displayWidth, picture.displayHeight);
  ImageRgbaF whole;
  whole.width = picture.displayWidth;
  whole.height = picture.displayHeight;
  whole.pixels.assign(std::size_t(4) * whole.width * whole.height, 0.0f);
  std::vector<float> distance(picture.distance.empty() ? 0 : whole.pixels.size() / 4, 0.0f);
  const ImageRgbaF& part = picture.image;
  const int left = std::max(0, -picture.offsetX), right = std::min(part.width, whole.width - picture.offsetX);
  for (int row = 0; row < part.height && left < right; ++row) {
    const int target = row + picture.offsetY;
    if (target < 0 || target >= whole.height) continue;
    const auto from = static_cast<std::ptrdiff_t>(row) * part.width + left;
    const auto to = static_cast<std::ptrdiff_t>(target) * whole.width + left + picture.offsetX;
    std::copy_n(part.pixels.begin() + 4 * from, 4 * (right - left), whole.pixels.begin() + 4 * to);
    if (!distance.empty()) std::copy_n(picture.distance.begin() + from, right - left, distance.begin() + to);
  }
  picture.image = std::move(whole);
  picture.distance = std::move(distance);
  picture.offsetX = picture.offsetY = 0;
}

CubeLayout detectLayout(CubeSource& source) {
  ExrPicture& picture = source.picture;
  if (picture.envmap) return *picture.envmap == EnvmapKind::LatLong ? CubeLayout::LatLong : CubeLayout::Strip;
  const CubeLayout byDisplay = layoutOfShape(picture.displayWidth, picture.displayHeight);
  if (byDisplay == CubeLayout::Automatic) return layoutOfShape(picture.image.width, picture.image.height);
  fillDisplayWindow(source);
  return byDisplay;
}

}  // namespace boxprobe
