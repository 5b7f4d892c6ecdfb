// The furnished room: what stands in it is not where its box would show it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/scenes/room_shell.h"
#include "tests/truth/scenes/truth_scenes.h"

namespace boxprobe::scenes {
namespace {

glm::dvec3 bands(double x, double y) {  // north: level, brighter towards the east
  return blend({0.40, 0.30, 0.12}, {0.75, 0.70, 0.55}, softLines(y, 0.5, 0.12, kSoft)) * (0.4 + 0.09 * x);
}

glm::dvec3 weave(double x, double y) {  // east
  const double a = softLines(x, 0.6, 0.15, kSoft), b = softLines(y, 0.6, 0.15, kSoft);
  return blend({0.10, 0.24, 0.30}, {0.32, 0.62, 0.68}, 0.5 * (a + b));
}

glm::dvec3 arches(double x, double y) {  // south
  const double middle = x - 1.2 * std::round(x / 1.2);
  const double outside = y < 1.3 ? std::abs(middle) - 0.38 : std::hypot(middle, y - 1.3) - 0.38;
  return blend({0.48, 0.20, 0.16}, {0.12, 0.04, 0.10}, softStep(0.0, kSoft, -outside));
}

glm::dvec3 slants(double x, double y) {  // west
  return blend({0.16, 0.34, 0.10}, {0.62, 0.74, 0.34}, softLines(x + 0.7 * y, 0.8, 0.2, kSoft)) * (0.5 + 0.2 * y);
}

glm::dvec3 boards(double x, double y) {  // the ceiling
  return blend({0.36, 0.33, 0.29}, {0.14, 0.11, 0.09}, softLines(y, 0.6, 0.06, kSoft)) * (1.15 - 0.12 * x);
}

glm::dvec3 shaggyCarpet(double x, double y) {
  return blend({0.06, 0.07, 0.12}, {0.20, 0.20, 0.26}, softLines(x, 0.8, 0.2, kSoft) * softLines(y, 0.8, 0.2, kSoft));
}

void addTable(MeshBuilder& wood) {
  const FaceUv uv = sidesOfPicture();
  wood.box({0.7, 0.70, -0.9}, {1.9, 0.76, 0.1}, uv);
  for (double x : {0.76, 1.76}) {
    for (double z : {-0.84, -0.04})
      wood.box({x, 0.0, z}, {x + 0.08, 0.70, z + 0.08}, uv, kAllFaces & ~(kPlusY | kMinusY));
  }
}

/// Against the east wall: two sides and five boards.
void addShelves(MeshBuilder& wood) {
  const FaceUv uv = sidesOfPicture();
  constexpr double kFront = 2.5, kBack = 2.9, kLeft = 0.4, kRight = 2.2, kBoard = 0.04, kPitch = 0.45;
  for (double z : {kLeft, kRight - kBoard})
    wood.box({kFront, 0.0, z}, {kBack, 1.95, z + kBoard}, uv, kAllFaces & ~(kPlusX | kMinusY));
  for (int i = 0; i < 5; ++i) {
    const double y = 0.08 + kPitch * i;
    wood.box({kFront, y, kLeft + kBoard}, {kBack, y + kBoard, kRight - kBoard}, uv, kMinusX | kPlusY | kMinusY);
  }
}

/// Against the south wall: seat, back and arms.
void addSofa(MeshBuilder& cloth) {
  const FaceUv uv = sidesOfPicture();
  cloth.box({-1.4, 0.12, 1.5}, {0.4, 0.42, 2.15}, uv, kPlusY | kMinusY | kMinusZ);
  cloth.box({-1.4, 0.12, 2.15}, {0.4, 0.86, 2.4}, uv, kPlusY | kMinusY | kMinusZ);
  for (double x : {-1.6, 0.4}) cloth.box({x, 0.0, 1.5}, {x + 0.2, 0.6, 2.4}, uv, kAllFaces & ~(kPlusZ | kMinusY));
}

}  // namespace

Model truthFurnished() {
  RoomShell shell;
  shell.low = {-2.9, 0.0, -2.4};
  shell.size = {5.8, 2.5, 4.8};
  shell.cutsX = {0.0, 1.0, 1.9, 3.6, 4.2, 5.8};
  shell.cutsY = {0.0, 1.1, 1.8, 2.5};
  shell.cutsZ = {0.0, 1.4, 2.0, 3.3, 3.5, 4.8};
  shell.north = {bands, {{"window", {3.6, 4.2, 1.1, 1.8}, {6.0f, 7.0f, 8.0f}}}};
  shell.east = {weave, {}};
  shell.south = {arches, {}};
  shell.west = {slants, {{"niche", {1.3, 1.5, 1.1, 1.8}, {10.0f, 6.0f, 3.0f}}}};
  shell.ceiling = {boards, {{"panel", {1.0, 1.9, 1.4, 2.0}, {10.0f, 9.5f, 8.5f}}}};
  shell.carpet = shaggyCarpet;
  Composer scene;
  addShell(scene, shell);

  MeshBuilder wood, cloth, cabinet, hanging;
  addTable(wood);
  addShelves(wood);
  addSofa(cloth);
  cabinet.box({-2.9, 0.0, -2.4}, {-1.9, 1.9, -1.8}, sidesOfPicture(), kPlusX | kPlusY | kPlusZ);
  hanging.box({1.1, 1.55, -0.6}, {1.5, 1.68, -0.2}, sidesOfPicture());
  const auto painted = [&](const char* name, const std::vector<glm::dvec3>& colors, double band) {
    return scene.material(unlit(name, sidesPicture(name, colors, band)));
  };
  // East, west, top, bottom, south, north.
  scene.add("wood", std::move(wood),
            painted("wood",
                    {{0.40, 0.18, 0.06},
                     {0.55, 0.30, 0.12},
                     {0.70, 0.48, 0.25},
                     {0.10, 0.04, 0.02},
                     {0.30, 0.10, 0.04},
                     {0.20, 0.12, 0.07}},
                    0.5));
  scene.add("sofa", std::move(cloth),
            painted("sofa",
                    {{0.10, 0.12, 0.40},
                     {0.06, 0.20, 0.50},
                     {0.25, 0.30, 0.65},
                     {0.02, 0.02, 0.08},
                     {0.1, 0.1, 0.1},
                     {0.16, 0.10, 0.45}},
                    0.4));
  scene.add("cabinet", std::move(cabinet),
            painted("cabinet",
                    {{0.65, 0.62, 0.50},
                     {0.1, 0.1, 0.1},
                     {0.45, 0.42, 0.36},
                     {0.1, 0.1, 0.1},
                     {0.30, 0.34, 0.28},
                     {0.1, 0.1, 0.1}},
                    0.6));
  scene.add("hanging lamp", std::move(hanging), scene.material(lamp("hanging lamp", {14.0f, 11.0f, 7.0f})));
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
