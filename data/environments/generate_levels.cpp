// Writes studio.levels beside studio.hdr: `generate_levels FOLDER`. Draws by OpenGL, as the program does when the file
// is not there.
#include <filesystem>
#include <iostream>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/sky_levels.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/vtk/probes/capture_key.h"

namespace {

using namespace boxprobe;

/// A triangle that reflects the sky, so that the sky's levels are needed.
std::shared_ptr<const Model> triangle() {
  Model model;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.indices = {0, 1, 2};
  model.meshes.push_back(mesh);
  Instance instance;
  instance.mesh = 0;
  model.instances.push_back(instance);
  return std::make_shared<const Model>(std::move(model));
}

void write(const std::filesystem::path& folder) {
  const std::string picture = (folder / "studio.hdr").string(), levels = skyLevelsFile(picture);
  std::filesystem::remove(levels);  // or it would be read
  Scene scene;
  scene.models.emplace_back();
  scene.sky = SkyImage{picture};
  scene.cameras.emplace_back();
  OffscreenScene shown(OffscreenSettings{"generate_levels", 16, 16});
  shown.show(scene, {triangle()}, {scene.cameras.front(), true, {}, {}, {}});
  shown.capture({});
  shown.requireHealthy();
  saveSkyLevels(levels, skyKey(scene, imageContentKey(loadSkyPicture(SkyImage{picture}))),
                *shown.renderer().mapsOnCpu(""));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "generate_levels FOLDER\n";
    return 2;
  }
  try {
    write(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "generate_levels: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
