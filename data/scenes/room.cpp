// The closed room: x in [-4, 4], y in [0, 3], z in [-3, 3], every wall in a plane of the probe's box, no light but the
// walls' own and a lamp in the ceiling's plane. Here box projection has no geometric error: what differs from a
// ray-traced picture is the program's. Edges in the pictures are soft over 4 cm, so that a probe's texel resolves them.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-4.0, 0.0, -3.0), kSize(8.0, 3.0, 6.0);
// The lamp's edges as fractions of the ceiling: x in [-1.6, 0], z in [-0.9, 0.3]. All surfaces are cut there, so that
// neighbours meet in the same vertices.
const std::vector<double> kCutsX = {0.0, 0.3, 0.5, 1.0}, kCutsZ = {0.0, 0.35, 0.55, 1.0}, kCutsY = {0.0, 1.0};
constexpr double kSoft = 0.04;  // metres
constexpr float kLampRadiance = 50.0f;

/// 1 inside a shape of signed distance `d` metres (negative inside).
double inside(double d) {
  return softStep(0.0, kSoft, -d);
}

double check(double x, double y, double size) {
  const auto wave = [size](double t) { return 2.0 * softLines(t - 0.5 * size, 2.0 * size, 0.5 * size, kSoft) - 1.0; };
  return 0.5 - 0.5 * wave(x) * wave(y);
}

/// What is painted on a wall, `x` metres from its left as seen from inside, `y` metres above its lower edge.
using Mural = glm::dvec3 (*)(double x, double y);

glm::dvec3 northMural(double x, double y) {  // discs of growing size on a warm check
  glm::dvec3 color = blend({0.42, 0.26, 0.16}, {0.60, 0.42, 0.28}, check(x, y, 0.25));
  const std::array<glm::dvec3, 4> colors = {
      {{0.85, 0.12, 0.06}, {0.95, 0.80, 0.20}, {0.06, 0.10, 0.30}, {0.9, 0.9, 0.85}}};
  for (int i = 0; i < 4; ++i)
    color = blend(color, colors[i], inside(std::hypot(x - (1.0 + 2.0 * i), y - 1.55) - (0.45 + 0.12 * i)));
  return color;
}

glm::dvec3 southMural(double x, double y) {  // slanted bands on a cool check
  glm::dvec3 color = blend({0.08, 0.17, 0.28}, {0.16, 0.32, 0.46}, check(x, y, 0.25));
  const double slanted = (x + 0.6 * y) * 0.857;
  const std::array<glm::dvec3, 3> colors = {{{0.10, 0.60, 0.55}, {0.80, 0.85, 0.90}, {0.75, 0.35, 0.10}}};
  for (int i = 0; i < 3; ++i) color = blend(color, colors[i], inside(std::abs(slanted - (1.6 + 2.2 * i)) - 0.36));
  return color;
}

glm::dvec3 eastMural(double x, double y) {  // green, two triangles
  glm::dvec3 color = blend({0.10, 0.30, 0.12}, {0.22, 0.46, 0.20}, check(x, y, 0.25));
  for (double middle : {1.6, 4.4}) {
    const double side = middle < 3.0 ? 1.0 : -1.0, rise = side * (y - 1.5);
    color = blend(color, middle < 3.0 ? glm::dvec3(0.95, 0.85, 0.30) : glm::dvec3(0.05, 0.05, 0.08),
                  inside(std::max(0.866 * std::abs(x - middle) + 0.5 * rise - 0.5, -rise - 0.65)));
  }
  return color;
}

glm::dvec3 westMural(double x, double y) {  // violet, a square in a square and upright bars
  glm::dvec3 color = blend({0.26, 0.12, 0.32}, {0.42, 0.24, 0.50}, check(x, y, 0.25));
  const double square = std::max(std::abs(x - 1.9), std::abs(y - 1.5));
  color = blend(color, {0.95, 0.55, 0.60}, inside(square - 0.95));
  color = blend(color, {0.15, 0.05, 0.20}, inside(square - 0.5));
  for (double bar : {3.8, 4.4, 5.0})
    color = blend(color, {0.90, 0.88, 0.80}, inside(std::max(std::abs(x - bar) - 0.13, std::abs(y - 1.5) - 1.1)));
  return color;
}

glm::dvec3 ceiling(double x, double y) {  // panels of 1 m with thin dark joints, shaded towards the far end
  const double joint = std::max(softLines(x, 1.0, 0.03, kSoft), softLines(y, 1.0, 0.03, kSoft));
  return blend(glm::dvec3(0.50, 0.50, 0.52) * (0.7 + 0.5 * x / 8.0), glm::dvec3(0.06), joint);
}

}  // namespace

Model room() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const auto addWall = [&scene](const std::string& name, Mural mural, MeshBuilder builder, glm::dvec2 metres) {
    // About 8 mm a texel: finer than a 512² cube-map face sees from the middle of the room.
    const int width = static_cast<int>(128 * metres.x), height = static_cast<int>(128 * metres.y);
    const Picture picture = paint(
        name, width, height, [mural, metres](double u, double v) { return mural(metres.x * u, metres.y * (1.0 - v)); });
    scene.add(name, std::move(builder), scene.material(unlit(name, picture)));
  };
  const auto reversed = [](std::vector<double> cuts) {
    std::reverse(cuts.begin(), cuts.end());
    for (double& cut : cuts) cut = 1.0 - cut;
    return cuts;
  };
  MeshBuilder north, south, east, west, top, lampPanel, floor;
  north.quadGrid(kLow, x, y, kCutsX, kCutsY);
  south.quadGrid(kLow + x + z, -x, y, reversed(kCutsX), kCutsY);
  east.quadGrid(kLow + x, z, y, kCutsZ, kCutsY);
  west.quadGrid(kLow + z, -z, y, reversed(kCutsZ), kCutsY);
  const auto isLamp = [](int column, int row) { return column == 1 && row == 1; };
  top.quadGrid(kLow + y, x, z, kCutsX, kCutsZ, {}, [&](int c, int r) { return !isLamp(c, r); });
  lampPanel.quadGrid(kLow + y, x, z, kCutsX, kCutsZ, {}, isLamp);
  floor.quadGrid(kLow + z, x, -z, kCutsX, reversed(kCutsZ));

  scene.add("floor", std::move(floor), scene.material(perfectMirror("floor")));
  addWall("wall north", northMural, std::move(north), {kSize.x, kSize.y});
  addWall("wall south", southMural, std::move(south), {kSize.x, kSize.y});
  addWall("wall east", eastMural, std::move(east), {kSize.z, kSize.y});
  addWall("wall west", westMural, std::move(west), {kSize.z, kSize.y});
  addWall("ceiling", ceiling, std::move(top), {kSize.x, kSize.z});
  scene.add("lamp", std::move(lampPanel), scene.material(lamp("lamp", glm::vec3(kLampRadiance))));

  const int ball = scene.mesh(sphere(0.45, 64), "sphere", scene.material(perfectMirror("sphere")));
  scene.place("sphere 1", ball, {-1.4, 0.45, -1.5});
  scene.place("sphere 2", ball, {1.6, 1.3, -1.0});
  scene.place("sphere 3", ball, {2.6, 0.45, 1.4});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
