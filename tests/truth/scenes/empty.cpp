// The empty room: box projection is exact in it, so that the integral over the box is the truth as well.
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/scenes/room_shell.h"
#include "tests/truth/scenes/truth_scenes.h"

namespace boxprobe::scenes {
namespace {

glm::dvec3 diamonds(double x, double y) {  // north
  const double a = softLines(x + y, 0.9, 0.22, kSoft), b = softLines(x - y, 0.9, 0.22, kSoft);
  return blend({0.06, 0.10, 0.32}, {0.85, 0.72, 0.30}, a * (1.0 - b) + b * (1.0 - a)) * (0.5 + 0.2 * y);
}

glm::dvec3 stripes(double x, double y) {  // east: upright, narrower towards the south
  const double phase = 0.8 * x + 0.22 * x * x;
  return blend({0.52, 0.05, 0.04}, {0.80, 0.62, 0.55}, softLines(phase, 1.0, 0.25, 0.12)) * (1.0 - 0.22 * y);
}

glm::dvec3 rings(double x, double y) {  // south
  const double radius = std::hypot(x - 1.7, y - 1.2);
  return blend({0.03, 0.16, 0.05}, {0.45, 0.80, 0.30}, softLines(radius, 0.7, 0.17, kSoft)) * (1.1 - 0.12 * x);
}

glm::dvec3 dots(double x, double y) {  // west: a dark wall with bright dots
  const double a = x - 0.65 * std::round(x / 0.65), b = y - 0.65 * std::round(y / 0.65);
  return blend({0.03, 0.03, 0.04}, {0.70, 0.75, 0.95}, softStep(0.0, kSoft, 0.17 - std::hypot(a, b)));
}

glm::dvec3 coffers(double x, double y) {  // the ceiling
  const double beam = std::max(softLines(x, 1.6, 0.14, kSoft), softLines(y, 1.3, 0.14, kSoft));
  return blend(glm::dvec3(0.30, 0.28, 0.24) * (0.5 + 0.12 * x), {0.05, 0.09, 0.12}, beam);
}

glm::dvec3 carpet(double x, double y) {
  return blend({0.10, 0.05, 0.04}, {0.25, 0.20, 0.12}, softLines(x + 0.5 * y, 1.0, 0.25, kSoft));
}

}  // namespace

Model truthEmpty() {
  RoomShell shell;
  shell.low = {-3.2, 0.0, -2.6};
  shell.size = {6.4, 2.7, 5.2};
  shell.cutsX = {0.0, 1.2, 2.0, 3.0, 4.4, 4.8, 6.4};
  shell.cutsY = {0.0, 0.8, 1.5, 1.9, 2.7};
  shell.cutsZ = {0.0, 1.0, 1.12, 2.2, 2.5, 3.4, 3.8, 5.2};
  shell.north = {diamonds, {}};
  shell.east = {stripes, {{"sconce", {2.2, 2.5, 1.5, 1.9}, {16.0f, 11.0f, 6.0f}}}};
  shell.south = {rings, {{"window", {3.4, 4.4, 0.8, 1.9}, {3.0f, 4.0f, 5.0f}}}};
  shell.west = {dots, {}};
  shell.ceiling = {coffers,
                   {{"strip", {1.2, 3.0, 1.0, 1.12}, {20.0f, 22.0f, 24.0f}},
                    {"square", {4.4, 4.8, 3.4, 3.8}, {28.0f, 24.0f, 18.0f}}}};
  shell.carpet = carpet;
  Composer scene;
  addShell(scene, shell);
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
