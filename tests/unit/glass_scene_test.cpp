// The glass room: that its solids are closed, which of them a shell describes, and that no probe sees glass.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <utility>

#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/math/cube/glass_shell.h"

namespace boxprobe {
namespace {

using Point = std::array<float, 3>;

Point rounded(const glm::vec3& p) {
  const auto part = [](float x) { return std::round(x * 1.0e5f) / 1.0e5f + 0.0f; };
  return {part(p.x), part(p.y), part(p.z)};
}

/// Edges that are not met by one in the other direction.
std::size_t openEdges(const Mesh& mesh) {
  std::map<std::pair<Point, Point>, int> edges;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = rounded(mesh.positions[mesh.indices[i + k]]);
      const Point b = rounded(mesh.positions[mesh.indices[i + (k + 1) % 3]]);
      if (a == b) continue;
      ++edges[{a, b}];
      --edges[{b, a}];
    }
  }
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second != 0; }));
}

TEST(GlassScene, SolidsAreClosedAndShellsFitThoseTheirMiddleSees) {
  const Model model = loadModelFile(BOXPROBE_DATA_DIR "/scenes/glass.glb");
  const std::map<std::string, bool> fits = {
      {"ball", true}, {"block", true}, {"prism", true}, {"ring", false}, {"cup", false}};
  std::size_t found = 0;
  for (const Mesh& mesh : model.meshes) {
    const auto expected = fits.find(mesh.name);
    if (expected == fits.end()) continue;
    ++found;
    EXPECT_EQ(openEdges(mesh), 0u) << mesh.name;
    const Material& material = model.materials[static_cast<std::size_t>(mesh.material)];
    EXPECT_TRUE(material.transmits() && !material.thin) << mesh.name;
    glm::vec3 low = mesh.positions.front(), high = low;
    for (const glm::vec3& p : mesh.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    std::vector<glm::vec3> positions;
    for (const glm::vec3& p : mesh.positions) positions.push_back(p - 0.5f * (low + high));
    const GlassShell shell(positions, mesh.normals, mesh.indices);
    EXPECT_EQ(shell.fits(), expected->second) << mesh.name << ", of its surface its middle sees " << shell.described();
  }
  EXPECT_EQ(found, fits.size());
}

TEST(GlassScene, EachThingHasAProbeThatSeesNoGlass) {
  const Scene scene = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/glass.boxprobe.json");
  for (const char* name : {"ball", "block", "prism", "ring", "cup", "pane"}) {
    const auto index = findProbe(scene, name);
    ASSERT_TRUE(index) << name;
    const std::vector<std::string>& hides = scene.probes[*index].hides;
    for (const char* other : {"ball", "block", "prism", "ring", "cup", "pane"}) {
      EXPECT_NE(std::find(hides.begin(), hides.end(), other), hides.end()) << name << " sees " << other;
    }
  }
}

}  // namespace
}  // namespace boxprobe
