#include "filters/io/cube/sky_picture.h"

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/cube/cube_source.h"
#include "filters/io/cube/picture_repair.h"

namespace boxprobe {

namespace {

ImageRgbaF read(const SkyImage& image, SkyPictureNotes& notes, std::optional<SkySun>* sun) {
  const std::string& path = image.file;
  const std::string extension = lowerExtension(path);
  if (extension != ".exr" && extension != ".hdr") {
    throw InputError(path + ": has an extension that is not read; use .exr or .hdr");
  }
  CubeSource found = readCubeSource(path, {});
  const CubeLayout layout = detectLayout(found);
  if (layout != CubeLayout::Strip && layout != CubeLayout::Cross) {
    if (layout == CubeLayout::Automatic) fillDisplayWindow(found);
    if (sun != nullptr) *sun = takeSun(found.picture.image, found.repairs.beyondHalf);
    spreadBeyondHalf(found.picture.image, found.repairs);
    notes = {CubeLayout::LatLong, std::move(found.repairs)};
    return std::move(found.picture.image);
  }
  LoadedCube cube = loadSkyCube(path, layout, image.cubeView, sun);
  notes = {layout, std::move(cube.repairs)};
  // The same number of texels around the horizon as in the cube.
  const int size = cube.radiance.faceSize();
  constexpr int kSamples = 2;  // along each axis
  const auto source = [&cube](const glm::vec3& direction) { return cube.radiance.fetch(direction, 0.0f); };
  return resampleToLatLong(source, 4 * size, 2 * size, kSamples);
}

}  // namespace

ImageRgbaF loadSkyPicture(const SkyImage& image, SkyPictureNotes* notes) {
  SkyPictureNotes found;
  ImageRgbaF pixels = withMemoryFor(image.file, [&] { return read(image, found, nullptr); });
  if (notes != nullptr) *notes = std::move(found);
  return pixels;
}

DrawnSky loadDrawnSky(const SkyImage& image) {
  DrawnSky sky;
  const auto sun = image.sun == SkySunForm::Lamp ? &sky.sun : nullptr;
  sky.image = withMemoryFor(image.file, [&] { return read(image, sky.notes, sun); });
  return sky;
}

}  // namespace boxprobe
