// The room with windows: x in [-4, 4], y in [0, 3.2], z in [-3, 3], its walls in the planes of the probe's box. A sun
// shines in through openings of every size: two broad ones with mullions in the east, narrow slits, a low one and one
// of coloured glass in the south. What lies outside is sky and nothing else, so that whatever a reflection shows in an
// opening is the sky's.
#include <algorithm>
#include <cmath>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-4.0, 0.0, -3.0), kSize(8.0, 3.2, 6.0);
// Metres from kLow. Every surface is cut where any opening begins or ends, so that neighbours meet in the same
// vertices.
const std::vector<double> kCutsX = {0.0, 0.8, 1.0, 1.4, 1.8, 2.2, 2.6, 3.2, 4.6, 5.4, 5.8, 6.2, 8.0};
const std::vector<double> kCutsY = {0.0, 0.4, 0.9, 1.2, 1.6, 1.68, 2.0, 2.4, 2.8, 3.2};
const std::vector<double> kCutsZ = {0.0, 0.6, 1.2, 1.28, 1.9, 3.6, 4.3, 4.38, 5.1, 6.0};
constexpr double kSoft = 0.04;  // metres, of painted edges
constexpr float kGlow = 0.12f;  // of walls, of their own colour: the light that they throw at each other

/// A rectangle of a wall, metres from the wall's left as seen from inside and from the floor.
struct Opening {
  double left, right, low, high;
  bool holds(double x, double y) const { return x > left && x < right && y > low && y < high; }
};

// Four panes about a cross of 8 cm, twice. East: x runs with z.
const Opening kEast[] = {{0.6, 1.2, 0.4, 1.6}, {1.28, 1.9, 0.4, 1.6}, {0.6, 1.2, 1.68, 2.8}, {1.28, 1.9, 1.68, 2.8},
                         {3.6, 4.3, 0.9, 1.6}, {4.38, 5.1, 0.9, 1.6}, {3.6, 4.3, 1.68, 2.4}, {4.38, 5.1, 1.68, 2.4}};
// South: x runs against x, from the east. Coloured glass first; a low one; three slits.
const Opening kSouth[] = {
    {1.8, 2.6, 0.9, 2.4}, {3.4, 4.8, 0.4, 1.2}, {5.4, 5.8, 0.4, 2.8}, {6.2, 6.6, 0.4, 2.8}, {7.0, 7.2, 0.4, 2.8}};
constexpr std::size_t kStained = 0;

std::vector<double> reversed(std::vector<double> cuts) {
  std::reverse(cuts.begin(), cuts.end());
  const double whole = cuts.front();
  for (double& cut : cuts) cut = whole - cut;
  return cuts;
}

std::vector<double> fractions(std::vector<double> metres) {
  const double whole = metres.back();
  for (double& cut : metres) cut /= whole;
  return metres;
}

/// The part of a wall that `keep` says, asked at the middle of each cell in metres.
MeshBuilder part(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, const std::vector<double>& across,
                 const std::vector<double>& along, const std::function<bool(double, double)>& keep) {
  MeshBuilder mesh;
  mesh.quadGrid(corner, right, up, fractions(across), fractions(along), {}, [&](int column, int row) {
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    return keep(0.5 * (across[c] + across[c + 1]), 0.5 * (along[r] + along[r + 1]));
  });
  return mesh;
}

glm::dvec3 plaster(glm::dvec3 color, double x, double y) {
  color = color * (0.9 + 0.2 * noise(1.3 * x, 1.3 * y, 12, 6, 71));
  return blend(color, {0.20, 0.12, 0.07}, softStep(0.0, kSoft, 0.12 - y));
}

glm::dvec3 tiles(double x, double y) {  // pale stone of half a metre
  const double tint = hash(static_cast<int>(2.0 * x), static_cast<int>(2.0 * y), 72);
  const glm::dvec3 stone =
      blend({0.66, 0.62, 0.55}, {0.82, 0.80, 0.75}, tint) * (0.94 + 0.12 * noise(3.0 * x, 3.0 * y, 24, 18, 73));
  return blend(stone, {0.34, 0.31, 0.27}, std::max(softLines(x, 0.5, 0.008, 0.02), softLines(y, 0.5, 0.008, 0.02)));
}

}  // namespace

Model windows() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const auto always = [](double, double) { return true; };
  const auto painted = [](const std::string& name, glm::dvec2 metres, const Pattern& pattern) {
    return lit(name, paint(name, static_cast<int>(48 * metres.x), static_cast<int>(48 * metres.y), pattern), kGlow);
  };
  const auto wall = [&](const std::string& name, double width, glm::dvec3 color) {
    return scene.material(painted(name, {width, kSize.y},
                                  [=](double u, double v) { return plaster(color, width * u, kSize.y * (1.0 - v)); }));
  };
  const auto anyOf = [](const auto& openings, std::size_t count) {
    return [&openings, count](double across, double up) {
      return std::none_of(openings, openings + count, [&](const Opening& o) { return o.holds(across, up); });
    };
  };
  Material floor =
      painted("floor", {kSize.x, kSize.z}, [](double u, double v) { return tiles(kSize.x * u, kSize.z * v); });
  floor.roughness = 0.3f;
  floor.emissive = glm::vec3(0.0f);
  floor.emissiveTexture = {};
  scene.add("floor", part(kLow + z, x, -z, kCutsX, reversed(kCutsZ), always), scene.material(floor));
  scene.add("ceiling", part(kLow + y, x, z, kCutsX, kCutsZ, always), wall("ceiling", kSize.x, {0.62, 0.61, 0.58}));
  scene.add("wall north", part(kLow, x, y, kCutsX, kCutsY, always), wall("wall north", kSize.x, {0.58, 0.52, 0.42}));
  scene.add("wall west", part(kLow + z, -z, y, reversed(kCutsZ), kCutsY, always),
            wall("wall west", kSize.z, {0.36, 0.46, 0.50}));
  scene.add("wall east", part(kLow + x, z, y, kCutsZ, kCutsY, anyOf(kEast, std::size(kEast))),
            wall("wall east", kSize.z, {0.60, 0.56, 0.50}));
  scene.add("wall south", part(kLow + x + z, -x, y, reversed(kCutsX), kCutsY, anyOf(kSouth, std::size(kSouth))),
            wall("wall south", kSize.x, {0.60, 0.56, 0.50}));
  Material glass;
  glass.name = "coloured glass";
  glass.baseColor = glm::vec4(0.95f, 0.25f, 0.10f, 0.25f);
  glass.metallic = 0.0f;
  glass.roughness = 0.4f;
  glass.alphaMode = AlphaMode::Blend;
  scene.add("coloured glass",
            part(kLow + x + z, -x, y, reversed(kCutsX), kCutsY,
                 [](double across, double up) { return kSouth[kStained].holds(across, up); }),
            scene.material(glass));

  const int globe = scene.mesh(sphere(0.35, 48), "globe", scene.material(lit("globe", {0.70, 0.32, 0.10}, 0.0f)));
  scene.place("globe", globe, {1.6, 0.9, -0.4});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
