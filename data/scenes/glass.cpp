// The glass room: x in [-3, 3], y in [0, 3], z in [-2.5, 2.5], every wall in a plane of the probes' box and boldly
// painted, so that what glass does to it shows. On plinths a ball, a block that absorbs, a prism, a ring and a cup, and
// a pane on the floor: what a shell describes, what it does not, and what bends nothing. Solids are closed.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-3.0, 0.0, -2.5), kSize(6.0, 3.0, 5.0);
constexpr double kSoft = 0.03;  // metres: what a probe's texel resolves
constexpr double kTwoPi = 6.283185307179586;

/// Tiles of `size` metres, each in one of a wall's four colours, with dark joints.
glm::dvec3 tiles(double x, double y, double size, const std::array<glm::dvec3, 4>& colors, int seed) {
  const auto color = [&](double column, double row) {
    const int i = static_cast<int>(std::floor(column)), j = static_cast<int>(std::floor(row));
    // Neighbours differ: two of the four on the even tiles of a check, two on the odd ones.
    const int odd = ((i + j) % 2 + 2) % 2;
    return colors[static_cast<std::size_t>(2 * odd + (hash(i, j, seed) < 0.5 ? 0 : 1))];
  };
  const double joint = std::max(softLines(x, size, 0.02, kSoft), softLines(y, size, 0.02, kSoft));
  return blend(color(x / size, y / size), glm::dvec3(0.05), joint);
}

const std::array<std::array<glm::dvec3, 4>, 6> kColors = {
    {{{{0.70, 0.16, 0.10}, {0.85, 0.45, 0.12}, {0.30, 0.06, 0.05}, {0.45, 0.20, 0.06}}},    // +x
     {{{0.12, 0.45, 0.60}, {0.20, 0.65, 0.60}, {0.04, 0.16, 0.30}, {0.06, 0.25, 0.25}}},    // -x
     {{{0.75, 0.75, 0.72}, {0.62, 0.64, 0.68}, {0.40, 0.40, 0.42}, {0.46, 0.44, 0.40}}},    // +y
     {{{0.50, 0.44, 0.34}, {0.42, 0.34, 0.24}, {0.14, 0.12, 0.10}, {0.18, 0.14, 0.10}}},    // -y
     {{{0.45, 0.24, 0.60}, {0.62, 0.40, 0.70}, {0.16, 0.08, 0.26}, {0.24, 0.12, 0.30}}},    // +z
     {{{0.80, 0.76, 0.30}, {0.30, 0.60, 0.22}, {0.16, 0.30, 0.10}, {0.40, 0.34, 0.08}}}}};  // -z

MeshBuilder prism(double side, double length) {
  // An equilateral triangle upright in xy, drawn out along z, about its middle.
  const double h = side * std::sqrt(3.0) / 2.0;
  const glm::dvec3 a(-side / 2, -h / 3, -length / 2), b(side / 2, -h / 3, -length / 2),
      c(0.0, 2.0 * h / 3, -length / 2);
  const glm::dvec3 back(0, 0, length);
  MeshBuilder builder;
  builder.quadrilateral(a, b, b + back, a + back);
  builder.quadrilateral(b, c, c + back, b + back);
  builder.quadrilateral(c, a, a + back, c + back);
  // A triangle: its last corner twice.
  const auto end = [&builder](glm::dvec3 p, glm::dvec3 q, glm::dvec3 r) { builder.quadrilateral(p, q, r, r); };
  end(c, b, a);
  end(a + back, b + back, c + back);
  return builder;
}

MeshBuilder ring(double radius, double thickness, int slices) {
  std::vector<glm::dvec2> profile, normals;
  for (int i = 0; i <= slices / 3; ++i) {
    const double angle = kTwoPi * (static_cast<double>(i) / (slices / 3) - 0.25);
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    profile.push_back(glm::dvec2(radius, 0.0) + thickness * normal);
    normals.push_back(normal);
  }
  profile.back() = profile.front();
  MeshBuilder builder;
  builder.lathe(profile, normals, slices);
  return builder;
}

// Outside from the bottom up, over a round rim, inside down again; flat bottoms have normals of their own.
MeshBuilder cup(double radius, double height, double wall, int slices) {
  MeshBuilder builder;
  std::vector<glm::dvec2> profile, normals;
  const auto add = [&](glm::dvec2 point, glm::dvec2 normal) {
    profile.push_back(point);
    normals.push_back(normal);
  };
  const double half = height / 2.0;
  builder.lathe({{0.0, -half}, {radius, -half}}, {{0, -1}, {0, -1}}, slices);
  add({radius, -half}, {1, 0});
  add({radius, half - wall / 2}, {1, 0});
  for (int i = 1; i < 8; ++i) {
    const double angle = 0.5 * kTwoPi * i / 8;
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    add(glm::dvec2(radius - wall / 2, half - wall / 2) + wall / 2 * normal, normal);
  }
  add({radius - wall, half - wall / 2}, {-1, 0});
  add({radius - wall, wall - half}, {-1, 0});
  builder.lathe(profile, normals, slices);
  builder.lathe({{radius - wall, wall - half}, {0.0, wall - half}}, {{0, 1}, {0, 1}}, slices);
  return builder;
}

Material glass(const std::string& name, float thickness) {
  Material material;
  material.name = name;
  material.metallic = 0.0f;
  material.roughness = 0.0f;
  material.transmission = 1.0f;
  material.ior = 1.5f;
  material.thickness = thickness;
  material.thin = thickness == 0.0f;
  return material;
}

}  // namespace

Model glassRoom() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const auto wall = [&scene](const std::string& name, int face, glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up) {
    const glm::dvec2 metres(glm::length(right), glm::length(up));
    const Picture picture = paint(
        name, static_cast<int>(64 * metres.x), static_cast<int>(64 * metres.y), [face, metres](double u, double v) {
          return tiles(metres.x * u, metres.y * (1.0 - v), 0.5, kColors[static_cast<std::size_t>(face)], face);
        });
    MeshBuilder builder;
    builder.quad(corner, right, up);
    scene.add(name, std::move(builder), scene.material(unlit(name, picture)));
  };
  wall("wall east", 0, kLow + x, z, y);
  wall("wall west", 1, kLow + z, -z, y);
  wall("ceiling", 2, kLow + y, x, z);
  wall("floor", 3, kLow + z, x, -z);
  wall("wall south", 4, kLow + x + z, -x, y);
  wall("wall north", 5, kLow, x, y);

  const int stone = scene.material(unlit("plinth", {0.34, 0.33, 0.31}));
  MeshBuilder block;
  block.box({-0.28, 0.0, -0.28}, {0.28, 0.6, 0.28}, repeating(1.0), kAllFaces & ~kMinusY);
  const int plinth = scene.mesh(std::move(block), "plinth", stone);
  const std::array<glm::dvec2, 5> places = {{{-2.0, -0.9}, {-0.9, -0.3}, {0.3, -0.6}, {1.4, -0.2}, {2.3, -0.9}}};
  for (std::size_t i = 0; i < places.size(); ++i)
    scene.place("plinth " + std::to_string(i + 1), plinth, {places[i].x, 0.0, places[i].y});
  const auto on = [&places](std::size_t i, double height) {
    return glm::dvec3(places[i].x, 0.6 + height, places[i].y);
  };

  const int ball = scene.mesh(sphere(0.36, 96), "ball", scene.material(glass("ball", 0.5f)));
  scene.place("ball", ball, on(0, 0.37));
  Material tinted = glass("block", 0.3f);
  tinted.attenuationColor = glm::vec3(0.35f, 0.75f, 0.55f);
  tinted.attenuationDistance = 0.3f;
  MeshBuilder slab;
  slab.box({-0.26, -0.34, -0.12}, {0.26, 0.34, 0.12}, repeating(1.0));
  scene.place("block", scene.mesh(std::move(slab), "block", scene.material(tinted)), on(1, 0.35));
  scene.place("prism", scene.mesh(prism(0.5, 0.5), "prism", scene.material(glass("prism", 0.3f))), on(2, 0.16));
  scene.place("ring", scene.mesh(ring(0.26, 0.09, 72), "ring", scene.material(glass("ring", 0.14f))), on(3, 0.10));
  scene.place("cup", scene.mesh(cup(0.2, 0.46, 0.03, 72), "cup", scene.material(glass("cup", 0.03f))), on(4, 0.24));
  MeshBuilder sheet;
  sheet.quad({-0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.3, 0.0});
  Material pane = glass("pane", 0.0f);
  pane.doubleSided = true;
  scene.place("pane", scene.mesh(std::move(sheet), "pane", scene.material(pane)), {0.4, 0.01, 1.0});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
