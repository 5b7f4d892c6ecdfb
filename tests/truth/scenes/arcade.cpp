// The arcade: the side of a thick pillar, which the box does not have, stands between a reflected ray and the sky.
#include <cmath>
#include <utility>
#include <vector>

#include "data/scenes/picture.h"
#include "tests/truth/scenes/room_shell.h"
#include "tests/truth/scenes/truth_scenes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kHalfX = 4.5, kHalfZ = 3.5, kHeight = 3.4;  // of the space within, its floor at y = 0
constexpr double kThick = 0.9;                               // of pillars and beams, outwards
constexpr double kBeam = 2.8;                                // underside of the beams
constexpr double kGround = -0.02;                            // a little below the floor
constexpr double kPi = 3.141592653589793;

glm::dvec3 vault(double x, double y) {
  const double ring = softLines(std::hypot(x - 4.5, y - 3.5), 1.1, 0.28, kSoft);
  return blend({0.12, 0.10, 0.16}, {0.50, 0.42, 0.30}, ring) * (0.55 + 0.1 * y);
}

glm::dvec3 paving(double x, double y) {
  const double joint = std::max(softLines(x, 1.5, 0.06, kSoft), softLines(y, 1.5, 0.06, kSoft));
  return blend({0.22, 0.20, 0.15}, {0.08, 0.10, 0.05}, joint);
}

struct Pillar {
  double middle, width;
};

void addPillars(MeshBuilder& stone) {
  const FaceUv uv = sidesOfPicture();
  constexpr unsigned kUpright = kPlusX | kMinusX | kPlusZ | kMinusZ;
  const std::vector<Pillar> along = {{-4.1, 0.8}, {-1.3, 0.9}, {1.5, 0.7}, {4.1, 0.8}};
  const std::vector<Pillar> across = {{-3.1, 0.8}, {0.2, 1.1}, {3.1, 0.8}};
  for (const Pillar& p : along) {
    const double left = p.middle - 0.5 * p.width, right = p.middle + 0.5 * p.width;
    stone.box({left, kGround, -kHalfZ - kThick}, {right, kBeam, -kHalfZ}, uv, kUpright);
    stone.box({left, kGround, kHalfZ}, {right, kBeam, kHalfZ + kThick}, uv, kUpright);
  }
  for (const Pillar& p : across) {
    const double near = p.middle - 0.5 * p.width, far = p.middle + 0.5 * p.width;
    stone.box({-kHalfX - kThick, kGround, near}, {-kHalfX, kBeam, far}, uv, kUpright);
    stone.box({kHalfX, kGround, near}, {kHalfX + kThick, kBeam, far}, uv, kUpright);
  }
}

void addBeams(MeshBuilder& stone) {
  const FaceUv uv = sidesOfPicture();
  const double farX = kHalfX + kThick, farZ = kHalfZ + kThick;
  stone.box({-farX, kBeam, -farZ}, {farX, kHeight, -kHalfZ}, uv, kMinusY | kPlusZ | kMinusZ);
  stone.box({-farX, kBeam, kHalfZ}, {farX, kHeight, farZ}, uv, kMinusY | kPlusZ | kMinusZ);
  stone.box({-farX, kBeam, -kHalfZ}, {-kHalfX, kHeight, kHalfZ}, uv, kMinusY | kPlusX | kMinusX);
  stone.box({kHalfX, kBeam, -kHalfZ}, {farX, kHeight, kHalfZ}, uv, kMinusY | kPlusX | kMinusX);
}

}  // namespace

Model truthArcade() {
  Composer scene;
  const glm::dvec3 x(2.0 * kHalfX, 0, 0), z(0, 0, 2.0 * kHalfZ);
  addFloor(scene, {-kHalfX, 0.0, kHalfZ}, x, -z);
  const std::vector<double> cutsX = fractions({0.0, 2.0, 2.5, 6.0, 7.2, 9.0}),
                            cutsZ = fractions({0.0, 1.6, 2.2, 4.9, 5.1, 7.0});
  constexpr double kTexels = 24.0;  // a metre
  addWall(
      scene, kTexels, "vault", MuralWall({-kHalfX, kHeight, -kHalfZ}, x, z, cutsX, cutsZ), vault,
      {{"lantern", {2.0, 2.5, 1.6, 2.2}, {12.0f, 9.0f, 5.0f}}, {"tube", {6.0, 7.2, 4.9, 5.1}, {9.0f, 11.0f, 14.0f}}});
  constexpr double kOut = 7.5;
  addWall(scene, 8.0, "ground", MuralWall({-kOut, kGround, kOut}, {2 * kOut, 0, 0}, {0, 0, -2 * kOut}, {0, 1}, {0, 1}),
          paving, {});

  MeshBuilder pillars, beams;
  addPillars(pillars);
  addBeams(beams);
  // East, west, top, bottom, south, north.
  scene.add("pillars", std::move(pillars),
            scene.material(unlit("pillars", sidesPicture("pillars",
                                                         {{0.65, 0.20, 0.10},
                                                          {0.12, 0.45, 0.30},
                                                          {0.2, 0.2, 0.2},
                                                          {0.2, 0.2, 0.2},
                                                          {0.70, 0.60, 0.20},
                                                          {0.14, 0.14, 0.40}},
                                                         0.7))));
  scene.add("beams", std::move(beams),
            scene.material(unlit("beams", sidesPicture("beams",
                                                       {{0.40, 0.30, 0.25},
                                                        {0.30, 0.34, 0.28},
                                                        {0.2, 0.2, 0.2},
                                                        {0.10, 0.08, 0.06},
                                                        {0.42, 0.38, 0.22},
                                                        {0.24, 0.22, 0.34}},
                                                       0.3))));
  return std::move(scene).finish();
}

std::string truthArcadeSky() {
  constexpr int kWidth = 256, kHeightTexels = 128;
  const glm::dvec3 quarters[4] = {{1.3, 0.9, 0.6}, {0.5, 1.1, 0.9}, {0.9, 0.7, 1.3}, {0.6, 0.8, 0.4}};
  const double sunLongitude = -0.75 * kPi / 2.0, sunLatitude = 0.45;  // from south towards west
  std::vector<float> rgb;
  for (int row = 0; row < kHeightTexels; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / kHeightTexels);
    for (int column = 0; column < kWidth; ++column) {
      const double longitude = 2.0 * kPi * (0.5 - (column + 0.5) / kWidth);  // from +Z towards +X
      const double turn = 4.0 * (column + 0.5) / kWidth;
      const int quarter = static_cast<int>(turn);
      const glm::dvec3 tint =
          blend(quarters[quarter], quarters[(quarter + 1) % 4], softStep(0.75, 0.4, turn - quarter));
      glm::dvec3 color = latitude < 0.0 ? glm::dvec3(0.10, 0.11, 0.08) : tint * (1.0 - 0.5 * latitude);
      // Bars that lean, so that neither a mirrored nor a turned sky looks the same.
      if (latitude >= 0.0) color *= 0.6 + 0.6 * softLines(longitude + 0.6 * latitude, kPi / 10.0, 0.06, 0.08);
      const double cosine = std::sin(latitude) * std::sin(sunLatitude) +
                            std::cos(latitude) * std::cos(sunLatitude) * std::cos(longitude - sunLongitude);
      color += glm::dvec3(14.0, 12.0, 8.0) * softStep(0.0, 0.06, 0.11 - std::acos(std::fmin(1.0, cosine)));
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(static_cast<float>(color[channel]));
    }
  }
  return hdrBytes(kWidth, kHeightTexels, rgb);
}

}  // namespace boxprobe::scenes
