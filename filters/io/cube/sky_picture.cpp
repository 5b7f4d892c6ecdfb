#include "filters/io/cube/sky_picture.h"

#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/cube/cube_source.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

ImageRgbaF loadSkyPicture(const std::string& path, std::size_t* notFinite) {
  ImageRgbaF image = loadHdrImage(path, notFinite);
  if (image.width == 2 * image.height) return image;  // no cube layout is twice as wide as high
  CubeSource found = readCubeSource(path, {});
  const CubeLayout layout = detectLayout(found);
  if (layout != CubeLayout::Strip && layout != CubeLayout::Cross) return image;
  const LoadedCube cube = loadCube(path, layout);
  // The same number of texels around the horizon as in the cube.
  const int size = cube.radiance.faceSize();
  constexpr int kSamples = 2;  // along each axis
  const auto source = [&cube](const glm::vec3& direction) { return cube.radiance.fetch(direction, 0.0f); };
  return resampleToLatLong(source, 4 * size, 2 * size, kSamples);
}

}  // namespace boxprobe
