// An object under a sky: light from all around, and a sun small enough to throw shadows.
#include <cmath>
#include <utility>

#include "data/scenes/picture.h"
#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kPi = 3.141592653589793;

/// A vase: its profile runs up the outside.
MeshBuilder vase() {
  std::vector<glm::dvec2> profile, normals;
  constexpr int kSteps = 28;
  const auto radius = [](double y) { return 0.16 + 0.13 * std::sin(4.1 * y + 0.5) * (1.1 - 0.6 * y); };
  profile.emplace_back(0.0, 0.0);
  normals.emplace_back(0.0, -1.0);
  for (int i = 0; i <= kSteps; ++i) {
    const double y = 0.95 * i / kSteps, slope = (radius(y + 1e-4) - radius(y - 1e-4)) / 2e-4;
    const double length = std::hypot(1.0, slope);
    profile.emplace_back(radius(y), y);
    normals.emplace_back(1.0 / length, -slope / length);
  }
  // The rims' normals are those of the side, but the lids are flat: each has a ring of its own.
  const double top = radius(0.95);
  profile.insert(profile.begin() + 1, glm::dvec2(radius(0.0), 0.0));
  normals.insert(normals.begin() + 1, glm::dvec2(0.0, -1.0));
  profile.emplace_back(top, 0.95);
  normals.emplace_back(0.0, 1.0);
  profile.emplace_back(0.0, 0.95);
  normals.emplace_back(0.0, 1.0);
  MeshBuilder builder;
  builder.lathe(profile, normals, 64);
  return builder;
}

}  // namespace

Model litObject() {
  Composer scene;
  const Picture tiles = paint("slab", 64, 64, [](double u, double v) {
    const double odd = softStep(0.5, 0.05, u) + softStep(0.5, 0.05, v);
    return blend({0.70, 0.64, 0.54}, {0.22, 0.20, 0.24}, odd * (2.0 - odd));
  });
  addTiledBox(scene, "slab", {-2.7, -0.12, -2.2}, {2.4, 0.0, 2.9}, 0.9, scene.material(lambert("slab", tiles)));
  addTurned(scene, "vase", vase(), {-0.25, 0.0, 0.1}, 0.0, scene.material(lambert("glaze", {0.24f, 0.52f, 0.44f})));
  scene.place("ball", scene.mesh(sphere(0.31, 64), "ball", scene.material(metal("brass", {0.91f, 0.69f, 0.31f}, 0.4f))),
              {0.75, 0.31, 0.45});
  MeshBuilder block, screen;
  block.box({-0.45, 0.0, -0.18}, {0.45, 0.36, 0.18}, repeating(1.0));
  addTurned(scene, "block", std::move(block), {0.2, 0.0, 1.05}, 28.0, scene.material(blackGloss("lacquer", 0.3f)));
  screen.box({-0.7, 0.0, -0.05}, {0.7, 0.9, 0.05}, repeating(1.0));
  addTurned(scene, "screen", std::move(screen), {-0.8, 0.0, -0.9}, -15.0,
            scene.material(lambert("coral", {0.78f, 0.33f, 0.24f})));
  return std::move(scene).finish();
}

std::string litObjectSky() {
  constexpr int kWidth = 256, kHeight = 128;
  const double sunLongitude = 0.9, sunLatitude = 0.75;  // from +Z towards +X, and up
  std::vector<float> rgb;
  for (int row = 0; row < kHeight; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / kHeight);
    for (int column = 0; column < kWidth; ++column) {
      const double longitude = 2.0 * kPi * (0.5 - (column + 0.5) / kWidth);
      glm::dvec3 color = latitude < 0.0 ? glm::dvec3(0.12, 0.10, 0.07) * (1.0 + 0.5 * std::cos(longitude - 2.0))
                                        : blend({0.85, 0.80, 0.70}, {0.16, 0.34, 0.85}, std::sin(latitude));
      // Clouds that lean to one side, so that neither a mirrored nor a turned sky looks the same.
      if (latitude >= 0.0) color *= 0.7 + 0.8 * softLines(longitude + 0.8 * latitude, 2.0 * kPi / 5.0, 0.2, 0.3);
      const double cosine = std::sin(latitude) * std::sin(sunLatitude) +
                            std::cos(latitude) * std::cos(sunLatitude) * std::cos(longitude - sunLongitude);
      color += glm::dvec3(1050.0, 900.0, 690.0) * softStep(0.0, 0.02, 0.04 - std::acos(std::fmin(1.0, cosine)));
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(static_cast<float>(color[channel]));
    }
  }
  return hdrBytes(kWidth, kHeight, rgb);
}

}  // namespace boxprobe::scenes
