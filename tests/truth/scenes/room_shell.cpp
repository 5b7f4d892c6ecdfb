#include "tests/truth/scenes/room_shell.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"

namespace boxprobe::scenes {
namespace {

constexpr double kTexels = 32.0;     // a metre of wall
constexpr double kSideMetres = 4.0;  // height of a column of the sides' picture
constexpr int kColumnTexels = 32, kRows = 128;

}  // namespace

void addFloor(Composer& scene, glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up) {
  MeshBuilder floor;
  floor.quad(corner, right, up);
  scene.add("floor", std::move(floor), scene.material(perfectMirror("floor")));
}

void addShell(Composer& scene, const RoomShell& shell) {
  const glm::dvec3 low = shell.low, x(shell.size.x, 0, 0), y(0, shell.size.y, 0), z(0, 0, shell.size.z);
  const std::vector<double> cutsX = fractions(shell.cutsX), cutsY = fractions(shell.cutsY),
                            cutsZ = fractions(shell.cutsZ);
  const MuralWall ground(low + z, x, -z, cutsX, reversed(cutsZ));
  scene.add("floor", ground.part([](double, double) { return true; }), scene.material(perfectMirror("floor")));
  addWall(scene, kTexels, "carpet", ground, shell.carpet, {});
  addWall(scene, kTexels, "wall north", MuralWall(low, x, y, cutsX, cutsY), shell.north.mural, shell.north.lamps);
  addWall(scene, kTexels, "wall east", MuralWall(low + x, z, y, cutsZ, cutsY), shell.east.mural, shell.east.lamps);
  addWall(scene, kTexels, "wall south", MuralWall(low + x + z, -x, y, reversed(cutsX), cutsY), shell.south.mural,
          shell.south.lamps);
  addWall(scene, kTexels, "wall west", MuralWall(low + z, -z, y, reversed(cutsZ), cutsY), shell.west.mural,
          shell.west.lamps);
  addWall(scene, kTexels, "ceiling", MuralWall(low + y, x, z, cutsX, cutsZ), shell.ceiling.mural, shell.ceiling.lamps);
}

Picture sidesPicture(const std::string& name, const std::vector<glm::dvec3>& sixColors, double bandMetres) {
  return paint(name, 6 * kColumnTexels, kRows, [&](double u, double v) {
    const auto column = static_cast<std::size_t>(std::clamp(6.0 * u, 0.0, 5.999));
    const double height = kSideMetres * (1.0 - v);
    const double band = softLines(height, bandMetres, 0.2 * bandMetres, 0.08);
    return sixColors.at(column) * (0.45 + 0.55 * band) * (0.7 + 0.3 * height / kSideMetres);
  });
}

FaceUv sidesOfPicture() {
  return [](unsigned face, glm::dvec2 size) {
    int column = 0;
    while ((1u << column) < face) ++column;
    // A quarter of a column is left at its borders, so that small mip levels mix little of the neighbours in.
    const double left = (column + 0.25) / 6.0, right = (column + 0.75) / 6.0;
    return UvRectangle{left, 1.0 - std::min(size.y, kSideMetres) / kSideMetres, right, 1.0};
  };
}

}  // namespace boxprobe::scenes
