// What a rough floor reflects under the footprint techniques, along lines across the picture: as smooth as the integral
// they stand for. No line where a level ends, none where the wall that the rays meet changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "filters/reference/light/reference_box.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 320, kHeight = 180, kStep = 2, kRays = 4096;

double display(const glm::dvec3& light) {
  const double x = std::max((light.x + light.y + light.z) / 3.0, 0.0);
  return std::pow(x / (1.0 + x), 1.0 / 2.2);
}

glm::dvec3 integral(const Explanation& e, const CubeMap& capture) {
  const double alpha = static_cast<double>(e.surface.roughness) * static_cast<double>(e.surface.roughness);
  const VisibleNormalLobe lobe(glm::normalize(glm::dvec3(e.surface.normalWorld)),
                               glm::normalize(glm::dvec3(e.surface.viewWorld)), alpha);
  const BoxWorld world(e.probes.at(0), capture);
  // The same rays at every pixel: what is left of their noise is smooth.
  return lobeMean(lobe, glm::dvec3(1.0), glm::dvec3(1.0), kRays, 1,
                  [&](const glm::dvec3& l) { return world.radiance(l); });
}

// Pixels at the foot of a wall, where all that the floor reflects changes from one to the next.
constexpr std::size_t kFoot = 6;

// Largest bend of a line of values over kStep pixels to either side.
double largestBend(const std::vector<double>& line) {
  double largest = 0.0;
  for (std::size_t i = kFoot + kStep; i + kStep < line.size(); ++i) {
    largest = std::max(largest, std::abs(line[i - kStep] - 2.0 * line[i] + line[i + kStep]));
  }
  return largest;
}

// The room's empty floor, low: the reflections of two walls, their edges and the lamps of the ceiling.
TEST(Footprints, DrawNoLinesAcrossARoughFloor) {
  for (const float roughness : {0.35f, 0.7f}) {
    Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
    for (const char* sphere : {"sphere 1", "sphere 2", "sphere 3"}) scene.objects[sphere].visible = false;
    scene.materials["floor"].roughness = roughness;
    ScenePicture picture(scene, kWidth, kHeight);
    const Camera camera = cameraNamed(scene, "A");
    std::vector<std::vector<glm::ivec2>> lines;
    for (const int y : {120, 140, 170}) {
      lines.emplace_back();
      for (int x = 0; x < kWidth; ++x) lines.back().emplace_back(x, y);
    }
    for (const int x : {60, 160, 250}) {
      lines.emplace_back();
      for (int y = 90; y < kHeight; ++y) lines.back().emplace_back(x, y);
    }
    std::vector<double> allowed;
    for (const char* id : {"footprint1", "footprint2", "footprint4", "footprint8", "footprint16"}) {
      picture.scene.probes[0].technique = id;
      picture.show(camera);
      keepPicture(picture.linear(), "footprint_floor_" + std::string(id) + (roughness < 0.5f ? "_glossy" : "_rough"));
      const auto maps = picture.renderer->mapsOnCpu(picture.scene.probes[0].name);
      double worst = 0.0, bendOfIntegral = 0.0;
      for (std::size_t l = 0; l < lines.size(); ++l) {
        std::vector<double> drawn, truth;
        for (const Explanation& e : picture.renderer->explain(lines[l], kWidth, kHeight)) {
          if (!e.hit || e.surface.object != "floor") continue;
          drawn.push_back(display(glm::dvec3(e.probes.at(0).specular)));
          if (allowed.size() < lines.size()) truth.push_back(display(integral(e, maps->radiance)));
        }
        ASSERT_GT(drawn.size(), 20u);
        if (allowed.size() < lines.size()) allowed.push_back(largestBend(truth));
        bendOfIntegral = std::max(bendOfIntegral, allowed[l]);
        const double bend = largestBend(drawn);
        worst = std::max(worst, bend - allowed[l]);
        EXPECT_LT(bend, allowed[l] + 0.012) << id << ", roughness " << roughness << ", line " << l;
      }
      std::printf("  roughness %.2f %-12s bends by %.4f more than the integral, which bends by up to %.4f\n",
                  static_cast<double>(roughness), id, worst, bendOfIntegral);
    }
  }
}

}  // namespace
