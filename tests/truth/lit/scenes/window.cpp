// A room with a window: sun and sky come in through one opening.
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {

Model litWindow() {
  Composer scene;
  const glm::dvec3 low(-2.6, 0.0, -2.1), high(2.2, 2.75, 1.7);
  const double thick = 0.22;
  const int plaster = scene.material(lambert("plaster", {0.76f, 0.73f, 0.66f}));
  const Picture rug = paint("rug", 64, 64, [](double u, double v) {
    const double band = softLines(u, 0.5, 0.1, 0.06), edge = softLines(v, 1.0, 0.12, 0.06);
    return blend(blend({0.42, 0.08, 0.07}, {0.64, 0.50, 0.30}, band), {0.10, 0.13, 0.30}, edge);
  });
  addRoom(scene, {low, high, thick, scene.material(lambert("oak", {0.52f, 0.37f, 0.23f})), plaster,
                  scene.material(lambert("sage", {0.45f, 0.55f, 0.40f})), -1,
                  scene.material(lambert("linen", {0.70f, 0.66f, 0.60f})),
                  scene.material(lambert("slate", {0.30f, 0.34f, 0.40f}))});
  // The east wall about a window of 1.6 x 1.25 m.
  const double x0 = high.x, x1 = high.x + thick;
  addBox(scene, "wall east below", {x0, 0.0, low.z}, {x1, 0.8, high.z}, plaster);
  addBox(scene, "wall east above", {x0, 2.05, low.z}, {x1, high.y, high.z}, plaster);
  addBox(scene, "wall east north", {x0, 0.8, low.z}, {x1, 2.05, -1.1}, plaster);
  addBox(scene, "wall east south", {x0, 0.8, 0.5}, {x1, 2.05, high.z}, plaster);
  addBox(scene, "mullion", {x0 + 0.08, 0.8, -0.42}, {x0 + 0.14, 2.05, -0.36},
         scene.material(lambert("frame", {0.25f, 0.15f, 0.09f})));
  MeshBuilder carpet;
  carpet.box({-1.2, 0.0, -0.7}, {1.2, 0.015, 0.7}, repeating(1.4));
  addTurned(scene, "rug", std::move(carpet), {-0.3, 0.0, -0.1}, 12.0, scene.material(lambert("rug", rug)));
  MeshBuilder desk;
  desk.box({-0.35, 0.0, -0.6}, {0.35, 0.74, 0.6}, repeating(1.0));
  addTurned(scene, "desk", std::move(desk), {-1.5, 0.0, -1.2}, 8.0,
            scene.material(lambert("turquoise", {0.20f, 0.56f, 0.55f})));
  scene.place("ball",
              scene.mesh(sphere(0.27, 64), "ball", scene.material(metal("copper", {0.93f, 0.55f, 0.40f}, 0.45f))),
              {-0.7, 0.285, 0.55});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
