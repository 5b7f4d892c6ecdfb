// Six differently coloured walls, four brightnesses on each: what a mirror ball shows of every quadrant, asserted by
// colour. The expected colours stand in data/scenes/README.md.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/shared/shared_math.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kSize = 401;
constexpr double kBallRadius = 0.5, kHalfRoom = 2.0;

const glm::vec3 kWallColors[6] = {{0.80f, 0.08f, 0.06f}, {0.06f, 0.62f, 0.66f}, {0.10f, 0.62f, 0.10f},
                                  {0.66f, 0.08f, 0.62f}, {0.08f, 0.16f, 0.85f}, {0.85f, 0.70f, 0.06f}};

float quadrant(double s, double t) {
  return t < 0 ? (s < 0 ? 1.0f : 0.65f) : (s < 0 ? 0.4f : 0.2f);
}

// The point of a mirror ball in the origin that shows `seen` to `eye`: its normal halves the angle between the two.
glm::dvec3 mirrorPoint(const glm::dvec3& eye, const glm::dvec3& seen) {
  glm::dvec3 p = kBallRadius * glm::normalize(glm::normalize(eye) + glm::normalize(seen));
  for (int i = 0; i < 200; ++i) p = kBallRadius * glm::normalize(glm::normalize(eye - p) + glm::normalize(seen - p));
  return p;
}

struct Pixel {
  int x, y;
};

Pixel project(const Camera& camera, const glm::dvec3& p) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec3 d = p - camera.position;
  const double scale =
      0.5 * kSize / std::tan(0.5 * camera.verticalFovDegrees * 3.14159265358979 / 180.0) / glm::dot(d, forward);
  return {static_cast<int>(std::floor(0.5 * kSize + scale * glm::dot(d, right))),
          static_cast<int>(std::floor(0.5 * kSize - scale * glm::dot(d, up)))};
}

TEST(Orientation, EveryQuadrantOfEveryWallIsWhereItBelongs) {
  ScenePicture picture = ScenePicture::fromFile("scenes/six-faces.boxprobe.json", kSize, kSize);
  int checked = 0;
  for (const char* technique : {"box", "infinite", "sphere"}) {
    picture.scene.probes[0].technique = technique;
    for (int from = 0; from < 6; ++from) {
      Camera camera;
      camera.position = 1.9 * glm::dvec3(shading::cubeDirection(from, 0.0f, 0.0f));
      camera.target = glm::dvec3(0.0);
      camera.up = glm::abs(camera.position.y) > 1.0 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
      camera.verticalFovDegrees = 35.0;
      picture.show(camera);
      const ImageRgbaF image = picture.linear(1);
      keepPicture(image, std::string("orientation_") + technique + "_" + std::to_string(from));
      for (int wall = 0; wall < 6; ++wall) {
        if (wall == (from ^ 1)) continue;  // behind the ball: a reflection squeezed into its rim
        for (const double s : {-0.4, 0.4}) {
          for (const double t : {-0.4, 0.4}) {
            const glm::dvec3 seen =
                kHalfRoom * glm::dvec3(shading::cubeDirection(wall, static_cast<float>(s), static_cast<float>(t)));
            const Pixel at = project(camera, mirrorPoint(camera.position, seen));
            ASSERT_TRUE(at.x >= 0 && at.y >= 0 && at.x < kSize && at.y < kSize);
            const float* c =
                &image.pixels[(static_cast<std::size_t>(at.y) * kSize + static_cast<std::size_t>(at.x)) * 4];
            const glm::vec3 expected = kWallColors[wall] * quadrant(s, t);
            // Box is exact. The others look in a direction that is off by up to asin(0.5 / 2); the quadrant's centre is
            // far enough from its border for the ball's middle, where it is checked.
            EXPECT_NEAR(c[0], expected.x, 0.02)
                << technique << " from " << from << " wall " << wall << " s " << s << " t " << t;
            EXPECT_NEAR(c[1], expected.y, 0.02)
                << technique << " from " << from << " wall " << wall << " s " << s << " t " << t;
            EXPECT_NEAR(c[2], expected.z, 0.02)
                << technique << " from " << from << " wall " << wall << " s " << s << " t " << t;
            ++checked;
          }
        }
      }
      if (std::string(technique) != "box") break;  // from one side only
    }
  }
  EXPECT_GE(checked, 6 * 5 * 4);
}

}  // namespace
