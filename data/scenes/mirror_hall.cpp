// The hall of mirrors: x in [-6, 6], y in [0, 4], z in [-4, 4], walls in the planes of the probe's box, so that what
// stands still is reflected exactly in most of it, and things that move before two mirrors: a large one on the north
// wall and a slightly rough floor. East of x = 4 stand what hides things (pillars) and a screen with a mirror on its
// far side; on the west wall hangs a plate too rough for a picture of its own.
#include <cmath>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-6.0, 0.0, -4.0), kSize(12.0, 4.0, 8.0);
constexpr double kSoft = 0.05;        // metres: edges that a probe's texel resolves
constexpr double kTexels = 48.0;      // a metre
constexpr double kBeforeWall = 0.01;  // mirrors hang a centimetre before their walls

using Mural = glm::dvec3 (*)(double x, double y);

/// Upright panels of a colour with darker joints, a frieze under the ceiling and a plinth.
glm::dvec3 panels(double x, double y, glm::dvec3 light, glm::dvec3 dark, double width) {
  const double joint = softLines(x, width, 0.06, kSoft);
  const double which = std::sin(3.1415926535 * (std::floor(x / width) + 0.5) * 0.5);
  glm::dvec3 color = blend(light, 0.8 * light, 0.5 + 0.5 * which);
  color = blend(color, dark, joint);
  color = blend(color, dark, softStep(-0.35, kSoft, -y));
  const double frieze = softLines(x - 0.25 * width, 0.5 * width, 0.12 * width, kSoft);
  const glm::dvec3 band = blend(0.6 * dark, {0.85, 0.68, 0.30}, frieze);
  return blend(color, band, softStep(3.3, kSoft, y));
}

glm::dvec3 north(double x, double y) {
  return panels(x, y, {0.34, 0.22, 0.16}, {0.12, 0.07, 0.05}, 1.5);
}
glm::dvec3 south(double x, double y) {
  glm::dvec3 color = panels(x, y, {0.20, 0.30, 0.38}, {0.05, 0.08, 0.12}, 1.5);
  for (int i = 0; i < 4; ++i) {  // round windows painted on
    const double away = std::hypot(x - (1.5 + 3.0 * i), y - 1.9);
    color = blend(color, {0.75, 0.78, 0.70}, softStep(-0.75, kSoft, -away));
    color = blend(color, {0.16, 0.42, 0.55}, softStep(-0.60, kSoft, -away));
  }
  return color;
}
glm::dvec3 east(double x, double y) {
  return panels(x, y, {0.24, 0.36, 0.20}, {0.06, 0.12, 0.05}, 2.0);
}
glm::dvec3 west(double x, double y) {
  return panels(x, y, {0.40, 0.30, 0.14}, {0.14, 0.09, 0.03}, 2.0);
}
glm::dvec3 ceiling(double x, double y) {
  const double beam = std::max(softLines(x, 2.0, 0.10, kSoft), softLines(y, 2.0, 0.10, kSoft));
  const glm::dvec3 color = blend({0.46, 0.45, 0.42}, {0.14, 0.11, 0.08}, beam);
  const double lamp = std::max(std::abs(std::remainder(x - 3.0, 4.0)), std::abs(std::remainder(y - 3.0, 4.0)));
  return blend(color, {1.0, 0.98, 0.92}, softStep(-0.45, kSoft, -lamp));
}

/// A profile of (radius, height) points turned about +Y, smooth along it.
MeshBuilder turned(const std::vector<glm::dvec2>& profile) {
  std::vector<glm::dvec2> normals;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const glm::dvec2 along = profile[std::min(i + 1, profile.size() - 1)] - profile[i == 0 ? 0 : i - 1];
    const double length = std::hypot(along.x, along.y);
    normals.emplace_back(along.y / length, -along.x / length);
  }
  MeshBuilder builder;
  builder.lathe(profile, normals, 40);
  return builder;
}

/// A figure of 1.7 m out of turned pieces, all of one node's name: robe, belt, collar and head.
void addFigure(Composer& scene, glm::dvec3 at) {
  const auto add = [&](const std::string& name, const std::vector<glm::dvec2>& profile, Material material) {
    scene.place("figure", scene.mesh(turned(profile), name, scene.material(std::move(material))), at);
  };
  const Picture stripes = paint("robe", 64, 32, [](double u, double) {
    return blend({0.62, 0.08, 0.10}, {0.78, 0.24, 0.12}, softLines(u, 0.125, 0.03, 0.02));
  });
  add("robe", {{0.36, 0.0}, {0.33, 0.2}, {0.27, 0.5}, {0.21, 0.8}, {0.18, 1.0}}, lit("robe", stripes, 0.35f));
  add("belt", {{0.215, 0.78}, {0.235, 0.81}, {0.235, 0.87}, {0.205, 0.90}},
      lit("belt", glm::vec3(0.90f, 0.70f, 0.18f), 0.35f));
  add("collar", {{0.18, 1.0}, {0.21, 1.1}, {0.225, 1.2}, {0.20, 1.3}, {0.14, 1.36}, {0.06, 1.39}},
      lit("collar", glm::vec3(0.92f, 0.90f, 0.84f), 0.35f));
  std::vector<glm::dvec2> head;
  for (int i = 0; i <= 16; ++i) {
    const double a = -1.3 + (1.5707963267948966 + 1.3) * i / 16.0;
    head.emplace_back(i == 16 ? 0.0 : 0.16 * std::cos(a), 1.54 + 0.16 * std::sin(a));
  }
  add("head", head, lit("head", glm::vec3(0.85f, 0.62f, 0.48f), 0.35f));
}

Picture cratePicture() {
  return paint("crate", 64, 64, [](double u, double v) {
    const double edge = std::max(std::abs(u - 0.5), std::abs(v - 0.5));
    const glm::dvec3 board = blend({0.10, 0.45, 0.50}, {0.20, 0.65, 0.62}, softLines(u, 0.25, 0.05, 0.04));
    return blend(board, {0.95, 0.80, 0.15}, softStep(0.40, 0.03, edge));
  });
}

}  // namespace

Model mirrorHall() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const auto addWall = [&scene](const std::string& name, Mural mural, glm::dvec3 corner, glm::dvec3 right,
                                glm::dvec3 up) {
    const double across = std::abs(right.x) + std::abs(right.z), high = std::abs(up.y) + std::abs(up.z);
    const Picture picture = paint(name, static_cast<int>(kTexels * across), static_cast<int>(kTexels * high),
                                  [=](double u, double v) { return mural(across * u, high * (1.0 - v)); });
    MeshBuilder wall;
    wall.quad(corner, right, up);
    scene.add(name, std::move(wall), scene.material(unlit(name, picture)));
  };
  addWall("wall north", north, kLow, x, y);
  addWall("wall south", south, kLow + x + z, -x, y);
  addWall("wall east", east, kLow + x, z, y);
  addWall("wall west", west, kLow + z, -z, y);
  addWall("ceiling", ceiling, kLow + y, x, z);

  const auto addMirror = [&scene](const std::string& name, float roughness, float white, glm::dvec3 corner,
                                  glm::dvec3 right, glm::dvec3 up) {
    Material material = perfectMirror(name);
    material.roughness = roughness;
    material.baseColor = glm::vec4(glm::vec3(white), 1.0f);
    MeshBuilder pane;
    pane.quad(corner, right, up);
    scene.add(name, std::move(pane), scene.material(material));
  };
  addMirror("floor", 0.1f, 0.7f, kLow + z, x, -z);
  addMirror("wall mirror", 0.0f, 0.95f, {-3.0, 0.3, kLow.z + kBeforeWall}, {6.0, 0, 0}, {0, 3.0, 0});
  addMirror("rough plate", 0.5f, 0.8f, {kLow.x + kBeforeWall, 0.6, 1.5}, {0, 0, -3.0}, {0, 2.0, 0});
  addMirror("far mirror", 0.0f, 0.95f, {4.92, 0.2, 3.2}, {0, 0, -1.4}, {0, 1.8, 0});

  MeshBuilder screen, pillars;
  screen.box({4.80, 0.0, 1.7}, {4.91, 2.1, 3.3}, repeating(1.0), kAllFaces & ~kMinusY);
  scene.add("screen", std::move(screen), scene.material(lit("screen", glm::vec3(0.35f, 0.12f, 0.30f), 0.3f)));
  for (const glm::dvec2& at : {glm::dvec2(4.4, -2.4), glm::dvec2(4.4, 0.2)}) {
    pillars.box({at.x - 0.22, 0.0, at.y - 0.22}, {at.x + 0.22, kSize.y, at.y + 0.22}, repeating(1.0),
                kAllFaces & ~(kMinusY | kPlusY));
  }
  scene.add("pillars", std::move(pillars), scene.material(lit("stone", glm::vec3(0.62f, 0.58f, 0.50f), 0.3f)));

  addFigure(scene, {-0.6, 0.0, -1.6});
  MeshBuilder crate;
  crate.box({-0.35, 0.0, -0.35}, {0.35, 0.7, 0.35}, [](unsigned, glm::dvec2) { return UvRectangle{}; });
  const int crateMesh = scene.mesh(std::move(crate), "crate", scene.material(lit("crate", cratePicture(), 0.35f)));
  scene.place("crate", crateMesh, {1.5, 0.0, -2.6});
  Material gold = perfectMirror("gold");
  gold.baseColor = glm::vec4(0.95f, 0.75f, 0.35f, 1.0f);
  gold.roughness = 0.2f;
  const int ball = scene.mesh(sphere(0.35, 40), "golden ball", scene.material(gold));
  scene.place("golden ball", ball, {-2.2, 0.35, -0.6});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
