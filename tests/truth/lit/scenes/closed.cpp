// The closed room: nothing but lamps and walls that light each other.
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {

Model litClosed() {
  Composer scene;
  const Picture wallPaper = paint("wall paper", 64, 64, [](double u, double v) {
    const double leaf = softLines(u + 0.5 * softLines(v, 1.0, 0.2, 0.3), 0.5, 0.11, 0.08);
    return blend({0.62, 0.55, 0.40}, {0.16, 0.34, 0.22}, leaf);
  });
  const Picture boards = paint("boards", 64, 64, [](double u, double v) {
    const double joint = softLines(v, 0.25, 0.012, 0.03);
    return blend(glm::dvec3(0.50, 0.30, 0.16) * (0.75 + 0.4 * softLines(u, 1.0, 0.2, 0.5)), {0.12, 0.06, 0.03}, joint);
  });
  addRoom(scene, {{-2.3, 0.0, -1.9},
                  {2.9, 2.6, 2.4},
                  0.1,
                  scene.material(lambert("boards", boards)),
                  scene.material(lambert("ceiling", {0.78f, 0.77f, 0.73f})),
                  scene.material(lambert("wall paper", wallPaper)),
                  scene.material(lambert("ochre", {0.66f, 0.45f, 0.18f})),
                  scene.material(lambert("blue grey", {0.34f, 0.42f, 0.52f})),
                  scene.material(lambert("brick", {0.58f, 0.22f, 0.15f})),
                  1.3,
                  1.1});
  addBox(scene, "panel", {0.4, 2.5, -0.9}, {1.5, 2.54, -0.2}, scene.material(glow("panel", {7.0f, 6.4f, 5.6f})));
  addBox(scene, "sconce", {-2.29, 1.52, 0.6}, {-2.21, 1.9, 0.95}, scene.material(glow("sconce", {11.0f, 6.5f, 3.2f})));
  scene.place("globe", scene.mesh(sphere(0.15, 32), "globe", scene.material(glow("globe", {5.0f, 7.5f, 10.0f}))),
              {2.2, 0.47, 1.7});
  MeshBuilder chest, stool;
  chest.box({-0.55, 0.0, -0.3}, {0.55, 0.8, 0.3}, repeating(1.0));
  stool.box({-0.21, 0.0, -0.21}, {0.21, 0.46, 0.21}, repeating(1.0));
  addTurned(scene, "chest", std::move(chest), {1.3, 0.0, -1.2}, 23.0,
            scene.material(lambert("green", {0.18f, 0.50f, 0.27f})));
  addTurned(scene, "stool", std::move(stool), {-0.9, 0.0, 0.5}, -37.0,
            scene.material(lambert("white", {0.82f, 0.80f, 0.79f})));
  scene.place("ball",
              scene.mesh(sphere(0.33, 64), "ball", scene.material(metal("brass", {0.91f, 0.68f, 0.29f}, 0.35f))),
              {0.45, 0.33, 0.75});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
