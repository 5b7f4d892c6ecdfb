// The room with a rough floor lit by few rays, and what its pixels should be: for tests of means of frames and of
// smoothed reflections.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "filters/reference/light/reference_box.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "tests/support/scene_picture.h"
#include "tests/support/shown_light.h"

namespace boxprobe::test {

constexpr int kWidth = 96, kHeight = 54;

inline Scene noisyRoom(double samples) {
  Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
  scene.lamps = LampForm::InMap;  // what rays find in the map is smoothed, not what stands for them
  Probe& probe = scene.probes.at(0);
  probe.faceSize = 64;
  probe.bounces = 1;  // a further one would show the technique's own error within reflections
  probe.samplesPerPixel = 1;
  probe.technique = "raytraced";
  probe.parameters = {{"samples", samples}, {"animated", true}};
  scene.materials["floor"].roughness = 0.35f;
  return scene;
}

inline const Camera& mainCamera(const Scene& scene) {
  return cameraNamed(scene, "main");
}

inline void setParameters(ScenePicture& picture, std::map<std::string, ParameterValue> parameters) {
  picture.scene.probes[0].parameters = std::move(parameters);
  picture.show(mainCamera(picture.scene));
}

struct NoisyRoomTruth {
  ImageRgbaF picture;            ///< every reflection integrated over its lobe in the box's world
  std::vector<bool> reflecting;  ///< not unlit
  std::vector<bool> rough;       ///< reflecting, and no mirror
  std::vector<bool> edges;       ///< of those, the ones within two pixels of another object
};

inline NoisyRoomTruth truthOf(ScenePicture& picture) {
  std::vector<glm::ivec2> places;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) places.emplace_back(x, y);
  }
  ReferenceBoxMaps maps;
  maps.probes.push_back(picture.renderer->mapsOnCpu(picture.scene.probes[0].name));
  maps.sky = picture.renderer->mapsOnCpu("");
  NoisyRoomTruth truth;
  truth.picture = {kWidth, kHeight, {}};
  const std::vector<Explanation> explained = picture.renderer->explain(places, kWidth, kHeight);
  for (const Explanation& e : explained) {
    constexpr int kRays = 512;
    const bool lit = e.hit && !e.probes.empty();
    const glm::dvec3 color =
        lit ? referenceBoxColor(litPoint(e), maps, kRays, hashBits(static_cast<std::uint64_t>(e.y * kWidth + e.x)))
            : glm::dvec3(e.color);
    for (int c = 0; c < 3; ++c) truth.picture.pixels.push_back(static_cast<float>(color[c]));
    truth.picture.pixels.push_back(1.0f);
    truth.reflecting.push_back(lit);
    truth.rough.push_back(lit && e.surface.roughness > 0.05f);
  }
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto at = [](int column, int row) { return static_cast<std::size_t>(row * kWidth + column); };
      bool edge = false;
      for (int j = std::max(y - 2, 0); j <= std::min(y + 2, kHeight - 1); ++j) {
        for (int i = std::max(x - 2, 0); i <= std::min(x + 2, kWidth - 1); ++i) {
          edge |= explained[at(i, j)].surface.object != explained[at(x, y)].surface.object;
        }
      }
      truth.edges.push_back(edge && truth.rough[at(x, y)]);
    }
  }
  return truth;
}

/// Of 255ths, between what a window shows and a linear picture at that exposure.
inline double largestDifference(const ImageRgba8& shown, const ImageRgbaF& linear, double exposure) {
  double largest = 0.0;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double expected = 255.0 * shownLight(linear.pixels[i] * exposure);
    largest = std::max(largest, std::abs(expected - shown.pixels[i]));
  }
  return largest;
}

}  // namespace boxprobe::test
