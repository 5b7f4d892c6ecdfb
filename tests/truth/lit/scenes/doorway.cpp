// Two rooms and a doorway: light in the eastern one alone, so that the western one has what comes through the door.
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {

Model litDoorway() {
  Composer scene;
  const Picture tiles = paint("tiles", 64, 64, [](double u, double v) {
    const double odd = softStep(0.5, 0.06, u) + softStep(0.5, 0.06, v);
    return blend({0.66, 0.62, 0.55}, {0.28, 0.32, 0.40}, odd * (2.0 - odd));
  });
  addRoom(scene, {{-3.4, 0.0, -2.2},
                  {4.3, 2.7, 2.6},
                  0.15,
                  scene.material(lambert("tiles", tiles)),
                  scene.material(lambert("ceiling", {0.80f, 0.80f, 0.78f})),
                  scene.material(lambert("sand", {0.70f, 0.63f, 0.48f})),
                  scene.material(lambert("petrol", {0.16f, 0.42f, 0.46f})),
                  scene.material(lambert("rose", {0.72f, 0.46f, 0.44f})),
                  scene.material(lambert("cream", {0.77f, 0.74f, 0.62f})),
                  0.8});
  const int white = scene.material(lambert("white", {0.74f, 0.75f, 0.77f}));
  // The wall between, about a doorway of 0.95 x 2.05 m.
  addBox(scene, "wall between north", {-0.16, 0.0, -2.2}, {0.05, 2.7, 0.4}, white);
  addBox(scene, "wall between south", {-0.16, 0.0, 1.35}, {0.05, 2.7, 2.6}, white);
  addBox(scene, "lintel", {-0.16, 2.05, 0.4}, {0.05, 2.7, 1.35}, white);
  MeshBuilder crate, bench;
  crate.box({-0.4, 0.0, -0.35}, {0.4, 0.7, 0.35}, repeating(1.0));
  addTurned(scene, "crate", std::move(crate), {-1.9, 0.0, -1.0}, 17.0,
            scene.material(lambert("orange", {0.75f, 0.36f, 0.10f})));
  addBox(scene, "bench", {1.2, 0.0, 1.9}, {3.1, 0.44, 2.45}, scene.material(lambert("violet", {0.33f, 0.22f, 0.47f})));
  MeshBuilder post;
  post.box({-0.16, 0.0, -0.16}, {0.16, 1.5, 0.16}, repeating(1.0));
  addTurned(scene, "post", std::move(post), {1.5, 0.0, -0.8}, 31.0,
            scene.material(lambert("lime", {0.47f, 0.62f, 0.18f})));
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
