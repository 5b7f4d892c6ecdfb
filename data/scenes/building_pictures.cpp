#include "data/scenes/building_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "data/scenes/picture.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kPlaster(0.66, 0.61, 0.53);
const glm::dvec3 kJoint(0.22, 0.20, 0.18);
const glm::dvec3 kCream(0.86, 0.82, 0.72);

// Terracotta, ochre, blue, green: far enough apart to be told by hue in a dim reflection.
const std::array<glm::dvec3, kSides> kSideColors = {
    {{0.56, 0.11, 0.05}, {0.78, 0.42, 0.04}, {0.03, 0.13, 0.45}, {0.05, 0.28, 0.13}}};

/// Splits a picture of `count` equal strips: which strip `x` lies in, and where in it.
struct Strip {
  int index;
  double position;  ///< in [0, 1]
};
Strip strip(double x, int count) {
  const int index = std::clamp(static_cast<int>(x * count), 0, count - 1);
  return {index, x * count - index};
}

/// 1 inside a shape of signed distance `d` (negative inside), soft over `width`.
double inside(double d, double width) {
  return softStep(0.0, width, -d);
}

/// Signed distance, in metres from the panel's middle, of a side's sign: disc, triangle, diamond, cross.
double signDistance(int side, double x, double y) {
  const double ax = std::abs(x), ay = std::abs(y);
  switch (side) {
    case kNorth:
      return std::hypot(x, y) - 0.62;
    case kEast:
      return std::max(0.866 * ax + 0.5 * y - 0.36, -y - 0.5);
    case kSouth:
      return 0.7071 * (ax + ay) - 0.48;
    default:
      return std::max(std::min(ax, ay) - 0.2, std::max(ax, ay) - 0.62);
  }
}

}  // namespace

Picture pillarPicture() {
  return paint("pillars", 512, 512, [](double u, double v) {
    const auto [side, x] = strip(u, kSides);
    const double width = 0.5, height = 5.0 * (1.0 - v), across = width * x;
    const double course = 0.625;
    const int block = static_cast<int>(height / course);
    glm::dvec3 color = kPlaster * (0.92 + 0.14 * hash(block, side, 1));
    color *= 0.94 + 0.12 * noise(2.0 * u * kSides, 10.0 * v, 8, 10, 2);
    for (int stripe = 0; stripe <= side; ++stripe) {
      const double distance = std::abs(height - (2.36 + 0.26 * stripe)) - 0.075;
      color = blend(color, kSideColors[side], inside(distance, 0.02));
    }
    color = blend(color, kJoint, 0.75 * softLines(height, course, 0.008, 0.012));
    const double edge = std::min(across, width - across);
    color *= 1.0 - 0.28 * (1.0 - softStep(0.018, 0.02, edge));
    return color * (0.72 + 0.28 * softStep(0.35, 0.7, height)) * (1.0 - 0.25 * softStep(4.3, 0.5, height));
  });
}

Picture screenPicture() {
  return paint("screens", 1024, 512, [](double u, double v) {
    const auto [side, x] = strip(u, kSides);
    const double width = 1.875, total = 4.2;
    const double across = width * (x - 0.5), height = total * (1.0 - v);
    const glm::dvec3 tint = kSideColors[side];
    const int column = static_cast<int>(std::floor(across / 0.375 + 0.5)), row = static_cast<int>(height / 0.35);
    const double shade = 0.9 + 0.2 * hash(column, row, 10 + side);
    glm::dvec3 color = blend(tint, kCream, 0.03) * shade;
    color = blend(color, kCream, inside(signDistance(side, across, height - 2.55), 0.02));
    color = blend(color, 0.55 * tint, inside(std::abs(height - 1.2) - 0.05, 0.02));
    color = blend(color, 0.55 * tint, inside(std::abs(height - 3.75) - 0.05, 0.02));
    const double grout =
        std::max(softLines(across - 0.1875, 0.375, 0.006, 0.012), softLines(height, 0.35, 0.006, 0.012));
    color = blend(color, 0.35 * tint + 0.08, 0.8 * grout);
    const double edge = 0.5 * width - std::abs(across);
    color *= 1.0 - 0.3 * (1.0 - softStep(0.02, 0.03, edge));
    return color * (0.78 + 0.22 * softStep(0.3, 0.6, height));
  });
}

Picture parapetPicture() {
  return paint("parapets", 512, 512, [](double u, double v) {
    const auto [side, y] = strip(v, kSides);
    const double x = 10.0 * u, z = 5.0 * y;  // in tiles
    const int column = static_cast<int>(x), row = static_cast<int>(z);
    const double dx = x - column - 0.5, dz = z - row - 0.5;
    const glm::dvec3 tint = kSideColors[side];
    const bool light = (column + row) % 2 == 0;
    const double shade = 0.9 + 0.2 * hash(column, row, 20 + side);
    glm::dvec3 color = (light ? kCream : tint) * shade;
    const double diamond = std::abs(dx) + std::abs(dz) - 0.3;
    color = blend(color, light ? tint : kCream, inside(diamond, 0.06));
    const double grout = std::max(softLines(x, 1.0, 0.03, 0.04), softLines(z, 1.0, 0.03, 0.04));
    return blend(color, kJoint, 0.8 * grout);
  });
}

Picture stonePicture() {
  return paint("stone", 256, 256, [](double u, double v) {
    const double x = 2.0 * u, y = 2.0 * v;  // two by two slabs of 0.75 m
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double shade = 0.86 + 0.2 * hash(column, row, 30);
    glm::dvec3 color = glm::dvec3(0.46, 0.44, 0.41) * shade * (0.93 + 0.14 * noise(12.0 * u, 12.0 * v, 12, 12, 31));
    return blend(color, 0.7 * kJoint, 0.8 * std::max(softLines(x, 1.0, 0.012, 0.02), softLines(y, 1.0, 0.012, 0.02)));
  });
}

Picture woodPicture() {
  return paint("wood", 256, 256, [](double u, double v) {
    const double bend = noise(4.0 * u, 2.0 * v, 4, 2, 40);
    const double grain = noise(3.0 * u, 24.0 * v + 2.0 * bend, 3, 24, 41);
    const double streak = noise(2.0 * u, 6.0 * v + bend, 2, 6, 42);
    const glm::dvec3 dark(0.16, 0.075, 0.03), light(0.42, 0.23, 0.10);
    return blend(dark, light, 0.25 + 0.35 * streak + 0.4 * softStep(0.5, 0.9, grain));
  });
}

Picture lawnPicture() {
  return paint("lawn", 256, 256, [](double u, double v) {
    // Mown in bands of 2 m both ways: a faint check that lets the eye follow the ground into the distance.
    const double a = softLines(4.0 * u - 0.5, 2.0, 0.5, 0.12), b = softLines(4.0 * v - 0.5, 2.0, 0.5, 0.12);
    const double band = a + b - 2.0 * a * b;
    const double patch = noise(8.0 * u, 8.0 * v, 8, 8, 50), tuft = noise(40.0 * u, 40.0 * v, 40, 40, 51);
    const glm::dvec3 dark(0.06, 0.115, 0.03), light(0.12, 0.19, 0.05);
    return blend(dark, light, 0.15 + 0.35 * band + 0.3 * patch + 0.2 * tuft);
  });
}

}  // namespace boxprobe::scenes
