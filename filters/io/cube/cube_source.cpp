#include "filters/io/cube/cube_source.h"

#include <algorithm>
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/image/image_detail.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

void cleanTexels(CubeSource& source) {
  std::vector<float>& pixels = source.picture.image.pixels;
  for (std::size_t texel = 0; texel < pixels.size(); texel += 4) {
    bool finite = true, inRange = true;
    for (std::size_t c = texel; c < texel + 4; ++c) {
      if (!std::isfinite(pixels[c])) {
        finite = false;
        pixels[c] = 0.0f;
      } else if (std::fabs(pixels[c]) > kHalfMax) {
        inRange = false;
        pixels[c] = std::copysign(kHalfMax, pixels[c]);
      }
    }
    source.texelsNotFinite += finite ? 0 : 1;
    source.texelsClamped += inRange ? 0 : 1;
  }
  for (float& distance : source.picture.distance) {
    if (!std::isfinite(distance) || distance < 0.0f) distance = 0.0f;
  }
}

/// Crops or pads to the display window: a writer may have omitted black borders or rendered overscan.
void fillDisplayWindow(ExrPicture& picture) {
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

/// The texels as stored, before any correction.
ImageRgbaF loadPicture(const std::string& path, const std::string& extension, const PictureCode& code,
                       std::size_t* notFinite) {
  if (code.encoding != ImageEncoding::Linear) return loadEncodedImage(path, code);
  if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") {
    throw InputError(
        path +
        ": has eight bits, which hold no radiance as it is; say how they are to be read with \"encoding\": "
        "\"rgbm\", \"dldr\" or \"rgbmLinear\", or use an EXR or HDR picture");
  }
  return loadHdrImage(path, notFinite);
}

}  // namespace

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

CubeSource readCubeSource(const std::string& path, const PictureCode& code) {
  CubeSource source;
  source.path = path;
  const std::string extension = lowerExtension(path);
  if (code.encoding == ImageEncoding::Linear && extension == ".exr") {
    withExrFile(path, [&](Imf::MultiPartInputFile& file) {
      source.picture = readExrPart(file, picturePart(file, path), path);
    });
  } else {
    source.picture.image = loadPicture(path, extension, code, &source.texelsNotFinite);
    source.picture.displayWidth = source.picture.image.width;
    source.picture.displayHeight = source.picture.image.height;
  }
  cleanTexels(source);
  return source;
}

CubeLayout layoutOfShape(long long width, long long height) {
  if (width == 2 * height) return CubeLayout::LatLong;
  if (width == 6 * height || height == 6 * width) return CubeLayout::Strip;
  if (3 * width == 4 * height && width % 4 == 0) return CubeLayout::Cross;
  if (4 * width == 3 * height && width % 3 == 0) return CubeLayout::Cross;
  return CubeLayout::Automatic;
}

CubeLayout detectLayout(CubeSource& source) {
  ExrPicture& picture = source.picture;
  if (picture.envmap) return *picture.envmap == EnvmapKind::LatLong ? CubeLayout::LatLong : CubeLayout::Strip;
  const CubeLayout byData = layoutOfShape(picture.image.width, picture.image.height);
  if (byData != CubeLayout::Automatic) return byData;
  const CubeLayout byDisplay = layoutOfShape(picture.displayWidth, picture.displayHeight);
  if (byDisplay != CubeLayout::Automatic) {
    checkImageSize(source.path, picture.displayWidth, picture.displayHeight);
    fillDisplayWindow(picture);
  }
  return byDisplay;
}

}  // namespace boxprobe
