// Colours that tell things apart do so for eyes without one kind of cones: simulated with the matrices of Machado,
// Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", IEEE TVCG 15(6),
// 2009, at full severity, on linear light; differences by CIE 1976 (L*a*b*, D65).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/picture/probe_color.h"
#include "filters/vtk/widgets/handle_colors.h"

namespace boxprobe {
namespace {

struct Vision {
  const char* name;
  double rows[3][3];
};

constexpr Vision kVisions[] = {
    {"all cones", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {"protanopia", {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {"deuteranopia",
     {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {"tritanopia",
     {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

glm::dvec3 labOf(const glm::dvec3& display, const Vision& vision) {
  glm::dvec3 light, seen(0.0);
  for (int c = 0; c < 3; ++c) {
    light[c] = display[c] <= 0.04045 ? display[c] / 12.92 : std::pow((display[c] + 0.055) / 1.055, 2.4);
  }
  for (int row = 0; row < 3; ++row) {
    for (int c = 0; c < 3; ++c) seen[row] += vision.rows[row][c] * light[c];
    seen[row] = std::clamp(seen[row], 0.0, 1.0);
  }
  const auto curve = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  const double x = curve((0.4124564 * seen.r + 0.3575761 * seen.g + 0.1804375 * seen.b) / 0.95047);
  const double y = curve(0.2126729 * seen.r + 0.7151522 * seen.g + 0.0721750 * seen.b);
  const double z = curve((0.0193339 * seen.r + 0.1191920 * seen.g + 0.9503041 * seen.b) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

void expectApart(const std::vector<glm::dvec3>& colors, const char* what) {
  for (const Vision& vision : kVisions) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(glm::distance(labOf(colors[i], vision), labOf(colors[j], vision)), 20.0)
            << what << " " << j << " and " << i << ", " << vision.name;
      }
    }
  }
}

TEST(ColorVision, TheSimulationIsThePublishedOne) {
  // White stays white for everyone; the red and green of before fall together for two of three.
  for (const Vision& vision : kVisions) EXPECT_NEAR(labOf(glm::dvec3(1.0), vision).x, 100.0, 0.1) << vision.name;
  const glm::dvec3 red = HandleColors::display(0x8c1f1a), green = HandleColors::display(0x1a6b24);
  EXPECT_GT(glm::distance(labOf(red, kVisions[0]), labOf(green, kVisions[0])), 60.0);
  EXPECT_LT(glm::distance(labOf(red, kVisions[2]), labOf(green, kVisions[2])), 20.0);
}

TEST(ColorVision, FacesAreToldApart) {
  std::vector<glm::dvec3> faces, rays;
  for (const glm::vec3& color : faceColors()) faces.emplace_back(color);
  for (const glm::vec3& color : faceColors()) rays.emplace_back(0.25f + 0.75f * color);  // as rays are drawn
  expectApart(faces, "faces");
  expectApart(rays, "rays to faces");
}

TEST(ColorVision, HandlesAreToldApart) {
  const HandleColors colors;
  expectApart({colors.axes.begin(), colors.axes.end()}, "axes");
  // The box of full weight and proposals are dashed, whatever their colour.
  expectApart({colors.box, colors.influence, colors.origin, colors.idle}, "lines and marks");
}

}  // namespace
}  // namespace boxprobe
