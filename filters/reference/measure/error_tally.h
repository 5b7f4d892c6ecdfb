// Sums differences between pairs of colours: the benchmark's metrics for pixels from several pictures. For two whole
// pictures use pictureError().
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

#include "filters/reference/measure/metrics.h"

namespace boxprobe {

class ErrorTally {
 public:
  void add(const glm::dvec3& value, const glm::dvec3& truth, double flip) {
    for (int c = 0; c < 3; ++c) {
      const double d = toneMapped(value[c]) - toneMapped(truth[c]);
      toneMappedSquares_ += d * d;
      squares_ += (value[c] - truth[c]) * (value[c] - truth[c]);
      truthSquares_ += truth[c] * truth[c];
      sum_ += value[c];
      truthSum_ += truth[c];
    }
    flip_ += flip;
    ++pixels_;
  }

  std::size_t pixels() const { return pixels_; }
  /// 0, and a brightness ratio of 1, if there is nothing to divide by: black on black.
  double toneMappedRmse() const {
    return std::sqrt(quotient(toneMappedSquares_, 3.0 * static_cast<double>(pixels_), 0.0));
  }
  double relativeRmse() const { return std::sqrt(quotient(squares_, truthSquares_, 0.0)); }
  double meanTruthSquare() const { return quotient(truthSquares_, 3.0 * static_cast<double>(pixels_), 0.0); }
  double brightnessRatio() const { return quotient(sum_, truthSum_, 1.0); }
  double flip() const { return quotient(flip_, static_cast<double>(pixels_), 0.0); }

 private:
  static double quotient(double a, double b, double otherwise) { return b > 0.0 ? a / b : otherwise; }

  double toneMappedSquares_ = 0.0, squares_ = 0.0, truthSquares_ = 0.0, sum_ = 0.0, truthSum_ = 0.0, flip_ = 0.0;
  std::size_t pixels_ = 0;
};

}  // namespace boxprobe
