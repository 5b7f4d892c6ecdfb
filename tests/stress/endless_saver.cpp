// Saves without end, to be killed: endless_saver scene FILE writes versions of one scene to FILE, endless_saver bake
// FOLDER the maps of three probes into FOLDER. What a version holds says its number in two places, so that a mixture
// would show. Prints a line once the first save is complete.
#include <cstdio>
#include <string>

#include "filters/io/cube/bake_folder.h"
#include "filters/io/scene/scene_file.h"

namespace {

using namespace boxprobe;

void saveScenes(const std::string& path) {
  Scene scene;
  for (int version = 1;; ++version) {
    // Longer and shorter by turns: what is left of a longer one would show as text after the end.
    scene.probes.assign(version % 2 == 0 ? 40 : 80, Probe());
    for (std::size_t i = 0; i < scene.probes.size(); ++i) scene.probes[i].name = "probe " + std::to_string(i);
    scene.exposure = version;
    scene.probes.back().intensity = version;
    saveSceneFile(scene, path);
    if (version == 1) std::puts("saved"), std::fflush(stdout);
  }
}

void saveBakes(const std::string& folder) {
  BakedMaps maps;
  maps.radiance = CubeMap(8, 3);
  maps.distance = CubeMap(8, 1);
  for (int version = 1;; ++version) {
    // Any half holds these exactly.
    const auto value = static_cast<float>(version % 2048);
    for (int level = 0; level < maps.radiance.levels(); ++level) {
      const int size = maps.radiance.levelSize(level), count = 6 * 4 * size * size;
      for (int i = 0; i < count; ++i) maps.radiance.face(level, 0)[i] = value;
    }
    Probe probe;
    probe.name = "probe " + std::to_string(version % 3);
    const std::string key = "v" + std::to_string(version % 2048);
    BakeFolder::save(folder, probe, {key, key, {}, {}}, maps, {"endless_saver", {}});
    if (version == 1) std::puts("saved"), std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  try {
    if (std::string(arguments[1]) == "scene") saveScenes(arguments[2]);
    saveBakes(arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
