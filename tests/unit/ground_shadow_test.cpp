// The light that a plane is left below a plate, against the form factor of a rectangle.
#include "filters/core/geometry/ground_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace boxprobe {
namespace {

/// One level plate, and nothing else in the world.
class Plate : public SightLines {
 public:
  Plate(glm::dvec2 low, glm::dvec2 high, double height) : low_(low), high_(high), height_(height) {}
  bool empty() const override { return false; }
  Box bounds() const override { return {{low_.x, height_, low_.y}, {high_.x, height_, high_.y}}; }
  bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool) const override {
    const double t = (height_ - from.y) / (to.y - from.y);
    if (!(t > 0.0 && t < 1.0)) return false;
    const double x = from.x + t * (to.x - from.x), z = from.z + t * (to.z - from.z);
    return x > low_.x && x < high_.x && z > low_.y && z < high_.y;
  }
  std::optional<Met> first(const glm::dvec3&, const glm::dvec3&) const override { return {}; }

  /// Of a small level piece of ground at (x, z) to the plate, as it is printed for a corner above the piece (Howell, A
  /// Catalog of Radiation Heat Transfer Configuration Factors, B-4): one corner's rectangle added, the others taken
  /// away.
  double factor(double x, double z, double y) const {
    const double h = height_ - y;
    const auto corner = [h](double a, double b) {
      const double u = std::abs(a) / h, v = std::abs(b) / h, p = std::sqrt(1.0 + u * u), q = std::sqrt(1.0 + v * v);
      const double f = (u / p * std::atan(v / p) + v / q * std::atan(u / q)) / (2.0 * 3.14159265358979323846);
      return (a < 0.0) == (b < 0.0) ? f : -f;
    };
    return corner(high_.x - x, high_.y - z) - corner(low_.x - x, high_.y - z) - corner(high_.x - x, low_.y - z) +
           corner(low_.x - x, low_.y - z);
  }

 private:
  glm::dvec2 low_, high_;
  double height_;
};

TEST(GroundShadow, IsTheFormFactorOfWhatStandsAbove) {
  const Plate plate({-0.9, 0.4}, {1.3, 1.7}, 0.8);
  // Far larger than the plate, so that its shadow ends before the plane does.
  const Box bounds{glm::dvec3(-3.1, 0.0, -2.6), glm::dvec3(3.4, 2.9, 4.1)};
  const GroundShadow shadow = tracedGroundShadow(plate, bounds);
  ASSERT_FALSE(shadow.empty());
  EXPECT_LT(shadow.height, 0.0);
  double squares = 0.0, darkest = 1.0;
  int count = 0;
  for (int row = 0; row < shadow.rows; ++row) {
    for (int column = 0; column < shadow.columns; ++column) {
      const double x = shadow.low.x + (column + 0.5) / shadow.columns * (shadow.high.x - shadow.low.x);
      const double z = shadow.low.y + (row + 0.5) / shadow.rows * (shadow.high.y - shadow.low.y);
      if (x < -2.0 || x > 2.6 || z < -1.1 || z > 3.0) continue;  // where the shadow is made to fade
      const double light = shadow.light[static_cast<std::size_t>(row * shadow.columns + column)];
      const double off = light - (1.0 - plate.factor(x, z, shadow.height));
      squares += off * off;
      darkest = std::min(darkest, light);
      ++count;
    }
  }
  const double rms = std::sqrt(squares / count);
  std::printf("  rms %.4f of the light over %d texels, darkest %.3f\n", rms, count, darkest);
  EXPECT_LT(darkest, 0.6);
  EXPECT_LT(rms, 0.015);
}

TEST(GroundShadow, EndsLit) {
  const GroundShadow shadow = tracedGroundShadow(Plate({-1.0, -0.7}, {1.2, 0.6}, 0.05),
                                                 {glm::dvec3(-1.0, 0.05, -0.7), glm::dvec3(1.2, 0.05, 0.6)});
  ASSERT_FALSE(shadow.empty());
  for (int column = 0; column < shadow.columns; ++column) {
    EXPECT_GT(shadow.light[static_cast<std::size_t>(column)], 0.99f);
  }
}

TEST(GroundShadow, OfNothingIsNone) {
  const Plate plate({-1.0, -1.0}, {1.0, 1.0}, 1.0);
  EXPECT_TRUE(tracedGroundShadow(plate, {glm::dvec3(0.4), glm::dvec3(0.4)}).empty());
  EXPECT_TRUE(tracedGroundShadow(plate, {glm::dvec3(0.0), glm::dvec3(1.0)}, [] { return true; }).empty());
}

}  // namespace
}  // namespace boxprobe
