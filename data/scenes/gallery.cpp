// The scene that techniques are measured in: a closed room of 10 x 3.5 x 7 m that is exactly its probe's box, with
// textured walls, small bright lamps in their planes, and four things to reflect them: a floor, half of it bumpy, a
// panel on a wall and a sphere. Box projection has no geometric error here, so what differs from a ray-traced picture
// is how a technique evaluates the lobe.
#include <algorithm>
#include <cmath>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/mural_wall.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-5.0, 0.0, -3.5), kSize(10.0, 3.5, 7.0);
// Where lamps and floors begin and end, metres from kLow. Every surface is cut there, so that neighbours meet in the
// same vertices.
const std::vector<double> kCutsX = {0.0, 1.0, 1.8, 2.0, 2.3, 3.6, 5.8, 6.8, 7.1, 8.2, 8.4, 10.0};
const std::vector<double> kCutsY = {0.0, 1.2, 2.0, 2.4, 3.5};
const std::vector<double> kCutsZ = {0.0, 1.5, 1.8, 2.4, 2.6, 3.3, 3.4, 5.0, 5.3, 7.0};
constexpr double kFloorEnd = 5.8;     ///< the bumpy part begins
constexpr double kBumpTile = 1.2;     ///< its picture repeats
constexpr double kSoft = 0.05;        ///< edges in pictures, metres
constexpr double kWallTexels = 64.0;  ///< a metre: as fine as a probe of 256² faces sees the nearest wall

glm::dvec3 bricks(double x, double y) {  // north: courses of 12 cm, every other one shifted
  const double course = y / 0.12, row = std::floor(course);
  const double shifted = x / 0.36 + (static_cast<int>(row) % 2 != 0 ? 0.5 : 0.0), column = std::floor(shifted);
  const double tint = hash(static_cast<int>(column), static_cast<int>(row), 61);
  const glm::dvec3 brick = blend({0.14, 0.035, 0.02}, {0.34, 0.13, 0.06}, tint);
  const double joint = std::max(softLines(shifted, 1.0, 0.03, 0.06), softLines(course, 1.0, 0.08, 0.15));
  return blend(brick, {0.30, 0.27, 0.23}, 0.85 * joint);
}

glm::dvec3 pictures(double x, double y) {  // south: a pale wall with framed pictures
  glm::dvec3 color = glm::dvec3(0.40, 0.38, 0.33) * (0.85 + 0.3 * noise(1.5 * x, 1.5 * y, 15, 6, 62));
  struct Frame {
    double x, y, halfWidth, halfHeight;
    glm::dvec3 a, b;
  };
  const Frame frames[] = {{1.6, 1.7, 0.7, 0.5, {0.05, 0.15, 0.45}, {0.95, 0.75, 0.15}},
                          {3.9, 1.6, 0.6, 0.8, {0.75, 0.06, 0.05}, {0.95, 0.9, 0.8}},
                          {6.3, 1.7, 0.9, 0.6, {0.03, 0.28, 0.12}, {0.65, 0.85, 0.95}}};
  for (const Frame& f : frames) {
    const double outside = std::max(std::abs(x - f.x) - f.halfWidth, std::abs(y - f.y) - f.halfHeight);
    const double u = (x - f.x) / f.halfWidth, v = (y - f.y) / f.halfHeight;
    const double waves = softStep(0.0, 0.5, std::sin(5.0 * u + 2.0 * std::sin(4.0 * v)) + 0.6 * v);
    color = blend(color, {0.03, 0.02, 0.015}, softStep(0.0, kSoft, 0.09 - outside));
    color = blend(color, blend(f.a, f.b, waves), softStep(0.0, kSoft, -outside));
  }
  return color;
}

glm::dvec3 tiles(double x, double y) {  // east: glazed tiles of 20 cm
  const int column = static_cast<int>(x / 0.2), row = static_cast<int>(y / 0.2);
  const glm::dvec3 tile = blend({0.01, 0.07, 0.11}, {0.06, 0.30, 0.30}, hash(column, row, 63));
  const double grout = std::max(softLines(x, 0.2, 0.008, 0.02), softLines(y, 0.2, 0.008, 0.02));
  return blend(tile, {0.35, 0.35, 0.32}, grout);
}

glm::dvec3 boards(double x, double y) {  // west: upright boards of 25 cm, grain along them
  const double board = x / 0.25;
  const int number = static_cast<int>(board);
  const double grain = noise(8.0 * x, 0.8 * y + 3.0 * hash(number, 0, 64), 80, 40, 65);
  const glm::dvec3 wood =
      blend({0.05, 0.022, 0.01}, {0.20, 0.11, 0.05}, 0.3 * hash(number, 1, 64) + 0.7 * softStep(0.2, 0.6, grain));
  return blend(wood, {0.02, 0.012, 0.008}, softLines(board, 1.0, 0.03, 0.06));
}

glm::dvec3 plaster(double x, double y) {  // the ceiling: pale, with two dark beams
  const glm::dvec3 white = glm::dvec3(0.26, 0.255, 0.24) * (0.9 + 0.2 * noise(1.0 * x, 1.0 * y, 10, 7, 66));
  const double beam = std::min(std::abs(x - 2.9), std::abs(x - 7.6)) - 0.15;
  return blend(white, {0.10, 0.055, 0.025}, softStep(0.0, kSoft, -beam));
}

glm::dvec3 carpet(double x, double y) {  // what probes see of the floor
  const double a = softLines(x - 0.25, 1.0, 0.25, kSoft), b = softLines(y - 0.25, 1.0, 0.25, kSoft);
  const glm::dvec3 weave = blend({0.08, 0.06, 0.05}, {0.19, 0.16, 0.12}, 0.5 * (a + b));
  const double rug = std::max(std::abs(x - 5.2) - 2.2, std::abs(y - 3.4) - 1.3);
  const glm::dvec3 pattern = blend({0.30, 0.02, 0.03}, {0.60, 0.42, 0.16}, softLines(x + y, 0.6, 0.1, kSoft));
  return blend(weave, pattern, softStep(0.0, kSoft, -rug));
}

/// Bumps with slopes of about 0.1, that repeat with the picture. Linear values, as a normal texture holds them.
Picture bumps() {
  constexpr int kTexels = 256;
  struct Wave {
    int across, down;
    double slope, phase;
  };
  const Wave waves[] = {
      {3, 1, 0.06, 0.3}, {-2, 4, 0.06, 1.9}, {5, -3, 0.05, 4.0}, {1, 6, 0.04, 2.7}, {7, 5, 0.03, 5.1}};
  auto image = std::make_shared<ImageRgba8>();
  image->name = "bumps";
  image->width = image->height = kTexels;
  for (int y = 0; y < kTexels; ++y) {
    for (int x = 0; x < kTexels; ++x) {
      glm::dvec2 slope(0.0);  // of the height, along the picture's right and its top
      for (const Wave& w : waves) {
        const double angle = 6.283185307179586 * (w.across * (x + 0.5) + w.down * (y + 0.5)) / kTexels + w.phase;
        const double length = std::hypot(w.across, w.down);
        slope += w.slope * std::cos(angle) * glm::dvec2(w.across, -w.down) / length;
      }
      const double scale = 1.0 / std::sqrt(1.0 + slope.x * slope.x + slope.y * slope.y);
      for (const double n : {-slope.x * scale, -slope.y * scale, scale})
        image->pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * (0.5 + 0.5 * n))));
      image->pixels.push_back(255);
    }
  }
  return image;
}

}  // namespace

Model gallery() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const std::vector<double> cutsX = fractions(kCutsX), cutsY = fractions(kCutsY), cutsZ = fractions(kCutsZ);

  const MuralWall floor(kLow + z, x, -z, cutsX, reversed(cutsZ));
  scene.add("floor", floor.part([](double across, double) { return across < kFloorEnd; }),
            scene.material(perfectMirror("floor")));
  Material bumpy = perfectMirror("bumpy floor");
  bumpy.normalTexture = {bumps(), Wrap::Repeat, Wrap::Repeat};
  Mesh bumpyFloor = floor
                        .part([](double across, double) { return across > kFloorEnd; },
                              {0.0, 0.0, kSize.x / kBumpTile, kSize.z / kBumpTile})
                        .finish("bumpy floor", scene.material(bumpy));
  bumpyFloor.tangents.assign(bumpyFloor.positions.size(), glm::vec4(1, 0, 0, 1));
  scene.place("bumpy floor", scene.mesh(std::move(bumpyFloor)));
  addWall(scene, kWallTexels, "carpet", floor, carpet, {});

  addWall(scene, kWallTexels, "wall north", MuralWall(kLow, x, y, cutsX, cutsY), bricks,
          {{"sconce north", {8.2, 8.4, 2.0, 2.4}, {18.0f, 14.0f, 9.0f}}});
  addWall(scene, kWallTexels, "wall south", MuralWall(kLow + x + z, -x, y, reversed(cutsX), cutsY), pictures,
          {{"window", {8.2, 9.0, 1.2, 2.4}, {5.0f, 6.4f, 8.0f}}});  // x runs west here: 1 m to 1.8 m from the west wall
  addWall(scene, kWallTexels, "wall east", MuralWall(kLow + x, z, y, cutsZ, cutsY), tiles,
          {{"sconce east", {2.4, 2.6, 2.0, 2.4}, {18.0f, 14.0f, 9.0f}}});
  addWall(scene, kWallTexels, "wall west", MuralWall(kLow + z, -z, y, reversed(cutsZ), cutsY), boards, {});
  addWall(scene, kWallTexels, "ceiling", MuralWall(kLow + y, x, z, cutsX, cutsZ), plaster,
          {{"spot 1", {2.0, 2.3, 1.5, 1.8}, {60.0f, 50.0f, 36.0f}},
           {"spot 2", {6.8, 7.1, 5.0, 5.3}, {60.0f, 50.0f, 36.0f}},
           {"tube", {3.6, 5.8, 3.3, 3.4}, {22.0f, 25.0f, 28.0f}}});

  MeshBuilder panel;  // in front of the boards, so that it reflects the room from near its west end
  panel.quad(kLow + glm::dvec3(0.02, 0.6, 5.0), glm::dvec3(0, 0, -3.0), glm::dvec3(0, 2.0, 0));
  scene.add("panel", std::move(panel), scene.material(perfectMirror("panel")));
  const int ball = scene.mesh(sphere(0.55, 64), "sphere", scene.material(perfectMirror("sphere")));
  scene.place("sphere", ball, {0.4, 0.55, -1.0});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
