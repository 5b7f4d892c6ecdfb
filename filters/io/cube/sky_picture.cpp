#include "filters/io/cube/sky_picture.h"

#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/cube/cube_source.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

ImageRgbaF loadSkyPicture(const std::string& path, std::size_t* notFinite) {
  ImageRgbaF image = loadHdrImage(path, notFinite);
  if (image.width == 2 * image.height) return image;  // no layout of a cube is twice as wide as high
  CubeSource found = readCubeSource(path, {});
  const CubeLayout layout = detectLayout(found);
  if (layout != CubeLayout::Strip && layout != CubeLayout::Cross) return image;
  const LoadedCube cube = loadCube(path, layout);
  // As many texels round the horizon as the cube has.
  const int size = cube.radiance.faceSize();
  constexpr int kSamples = 2;  // each way
  const auto source = [&cube](const glm::vec3& direction) { return cube.radiance.fetch(direction, 0.0f); };
  return resampleToLatLong(source, 4 * size, 2 * size, kSamples);
}

}  // namespace boxprobe
