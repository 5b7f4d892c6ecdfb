// A cube room, one picture a wall. The picture of a wall is laid on it exactly as the cube map's face of that direction
// stores it (OpenGL's convention), so a right capture from the middle gives the six pictures back:
//
//   left half  right half         brightness of the wall's colour; the mark is white, in the outer corner of the
//   [mark] 1      0.65    top     brightest quadrant. No turn or mirror image of this pattern is the pattern itself.
//          0.4    0.2     bottom
#include <array>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kHalf = 2.0;

struct Wall {
  const char* name;
  glm::dvec3 color;
  glm::dvec3 outward;
  glm::dvec3 columns, rows;  ///< where the picture's columns and rows run, OpenGL 4.5, table 8.19
};

const std::array<Wall, 6> kWalls = {{{"+X", {0.80, 0.08, 0.06}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                     {"-X", {0.06, 0.62, 0.66}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                     {"+Y", {0.10, 0.62, 0.10}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {"-Y", {0.66, 0.08, 0.62}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                     {"+Z", {0.08, 0.16, 0.85}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                     {"-Z", {0.85, 0.70, 0.06}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};

Picture wallPicture(const Wall& wall) {
  // Power-of-two edges: quadrants and mark end between texels, so that nothing is mixed at level 0.
  return paint(std::string("wall ") + wall.name, 64, 64, [color = wall.color](double u, double v) {
    if (u >= 0.0625 && u < 0.1875 && v >= 0.0625 && v < 0.1875) return glm::dvec3(1.0);
    return color * (v < 0.5 ? (u < 0.5 ? 1.0 : 0.65) : (u < 0.5 ? 0.4 : 0.2));
  });
}

}  // namespace

Model sixFaces() {
  Composer scene;
  for (const Wall& wall : kWalls) {
    MeshBuilder builder;
    // From inside, the columns run from right to left: a cube map's faces are drawn as seen from outside.
    const glm::dvec3 right = -2.0 * kHalf * wall.columns, up = -2.0 * kHalf * wall.rows;
    builder.quad(kHalf * wall.outward - 0.5 * (right + up), right, up, {1.0, 0.0, 0.0, 1.0});
    const std::string name = std::string("wall ") + wall.name;
    scene.add(name, std::move(builder), scene.material(unlit(name, wallPicture(wall))));
  }
  scene.add("ball", sphere(0.5, 64), scene.material(perfectMirror("ball")));
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
