// See prefilter_cubes.h.
#include "tests/bench/prefilter_cubes.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/io/cube/cube_file.h"
#include "filters/vtk/gl/gl_objects.h"
#include "tests/bench/harness.h"

namespace boxprobe::bench {

namespace {

CubeMap level0(const CubeMap& from) {
  CubeMap cube(from.faceSize(), 1);
  const auto floats = static_cast<std::size_t>(from.faceSize()) * static_cast<std::size_t>(from.faceSize()) * 4;
  for (int face = 0; face < 6; ++face) {
    std::copy_n(from.face(0, face), floats, cube.face(0, face));
    for (std::size_t i = 3; i < floats; i += 4) cube.face(0, face)[i] = 1.0f;
  }
  return cube;
}

// Through a texture and back: all prefilters then start from the same numbers.
CubeMap halfFloats(const CubeMap& cube) {
  CubeTexture texture;
  texture.allocate(cube.faceSize(), 1, GL_RGBA16F);
  CubeMap result(cube.faceSize(), 1);
  for (int face = 0; face < 6; ++face) {
    const auto floats = static_cast<std::size_t>(cube.faceSize()) * static_cast<std::size_t>(cube.faceSize()) * 4;
    texture.writeFace(face, 0, std::vector<float>(cube.face(0, face), cube.face(0, face) + floats));
    const std::vector<float> rgba = texture.readFace(face, 0);
    std::copy(rgba.begin(), rgba.end(), result.face(0, face));
  }
  return result;
}

CubeMap capturedRoom(vtkOpenGLRenderWindow* window, int faceSize) {
  LoadedScene loaded = loadScene(BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json");
  Probe& probe = loaded.scene.probes.at(0);
  probe.faceSize = faceSize;
  probe.origin += glm::dvec3(0.6, 0.4, -0.9);  // the lamp on no face's middle
  OffscreenScene drawn(window);
  prepare(drawn, loaded.scene, loaded.models);
  const auto maps = drawn.renderer().readMaps(probe.name);
  if (!maps) throw WorkError("the room's probe was not captured");
  return level0(maps->radiance);
}

CubeMap singleTexel(int faceSize) {
  CubeMap cube(faceSize, 1);
  for (int face = 0; face < 6; ++face) {
    std::fill_n(cube.face(0, face), static_cast<std::ptrdiff_t>(faceSize) * faceSize * 4, 1.0f);
  }
  cube.setTexel(0, 4, faceSize * 7 / 10, faceSize * 6 / 10, {50000.0f, 50000.0f, 50000.0f, 1.0f});
  return cube;
}

}  // namespace

std::vector<NamedCube> prefilterCubes(vtkOpenGLRenderWindow* window, int faceSize) {
  std::vector<NamedCube> cubes;
  cubes.push_back({"sky", halfFloats(level0(
                              loadCube(BOXPROBE_DATA_DIR "/scenes/sky.hdr", CubeLayout::LatLong, faceSize).radiance))});
  cubes.push_back({"room with a lamp", halfFloats(capturedRoom(window, faceSize))});
  cubes.push_back({"one bright texel", halfFloats(singleTexel(faceSize))});
  return cubes;
}

}  // namespace boxprobe::bench
