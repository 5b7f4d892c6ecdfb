// Furniture: shadows of boards and legs, a mirror, and shelves that light reaches by detours.
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {
namespace {

void addTable(Composer& scene, int wood) {
  addBox(scene, "table top", {0.5, 0.71, -0.95}, {1.9, 0.76, -0.05}, wood);
  int leg = 0;
  for (double x : {0.55, 1.78}) {
    for (double z : {-0.9, -0.17})
      addBox(scene, "leg " + std::to_string(++leg), {x, 0.0, z}, {x + 0.07, 0.71, z + 0.07}, wood);
  }
}

/// Against the west wall.
void addShelves(Composer& scene, int wood) {
  addBox(scene, "shelf side north", {-2.7, 0.0, -1.3}, {-2.35, 1.9, -1.26}, wood);
  addBox(scene, "shelf side south", {-2.7, 0.0, 0.36}, {-2.35, 1.9, 0.4}, wood);
  int board = 0;
  for (double y : {0.1, 0.55, 1.0, 1.4, 1.86})
    addBox(scene, "shelf " + std::to_string(++board), {-2.7, y, -1.26}, {-2.35, y + 0.035, 0.36}, wood);
}

}  // namespace

Model litFurniture() {
  Composer scene;
  const Picture carpet = paint("carpet", 64, 64, [](double u, double v) {
    const double a = softLines(u + v, 0.5, 0.1, 0.06), b = softLines(u - v, 1.0, 0.15, 0.06);
    return blend(blend({0.20, 0.24, 0.38}, {0.58, 0.52, 0.44}, a), {0.45, 0.12, 0.16}, b);
  });
  addRoom(scene, {{-2.7, 0.0, -2.0},
                  {2.4, 2.5, 2.3},
                  0.12,
                  scene.material(lambert("carpet", carpet)),
                  scene.material(lambert("ceiling", {0.80f, 0.79f, 0.76f})),
                  scene.material(lambert("mint", {0.52f, 0.66f, 0.56f})),
                  scene.material(lambert("clay", {0.62f, 0.38f, 0.27f})),
                  scene.material(lambert("straw", {0.73f, 0.66f, 0.42f})),
                  scene.material(lambert("dove", {0.60f, 0.60f, 0.65f})),
                  0.9});
  const int wood = scene.material(lambert("wood", {0.44f, 0.27f, 0.14f}));
  addTable(scene, wood);
  addShelves(scene, wood);
  const int books[] = {scene.material(lambert("red book", {0.60f, 0.10f, 0.09f})),
                       scene.material(lambert("blue book", {0.10f, 0.20f, 0.55f})),
                       scene.material(lambert("paper", {0.85f, 0.83f, 0.75f}))};
  addBox(scene, "book 1", {-2.66, 1.035, -1.1}, {-2.42, 1.31, -0.85}, books[0]);
  addBox(scene, "book 2", {-2.66, 0.585, -0.2}, {-2.4, 0.86, 0.2}, books[1]);
  addBox(scene, "book 3", {0.8, 0.76, -0.75}, {1.15, 0.82, -0.5}, books[2]);
  MeshBuilder bench;
  bench.box({-0.9, 0.0, -0.3}, {0.9, 0.42, 0.3}, repeating(1.0));
  addTurned(scene, "bench", std::move(bench), {-0.5, 0.0, 1.7}, 6.0,
            scene.material(lambert("moss", {0.36f, 0.44f, 0.16f})));
  // A wide lamp, so that paths find it by chance in the mirror as well.
  addBox(scene, "lamp", {-0.4, 2.28, -0.6}, {0.8, 2.36, 0.7}, scene.material(glow("lamp", {3.6f, 3.2f, 2.5f})));
  addBox(scene, "mirror", {-0.9, 0.9, -1.99}, {0.2, 1.9, -1.96},
         scene.material(metal("mirror", {0.94f, 0.95f, 0.96f}, 0.0f)));
  MeshBuilder tray;
  tray.box({-0.3, 0.0, -0.2}, {0.3, 0.03, 0.2}, repeating(1.0));
  addTurned(scene, "tray", std::move(tray), {1.45, 0.76, -0.35}, 20.0, scene.material(blackGloss("lacquer", 0.2f)));
  scene.place("vase", scene.mesh(sphere(0.12, 48), "vase", scene.material(metal("brass", {0.90f, 0.70f, 0.33f}, 0.3f))),
              {0.72, 0.88, -0.22});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
