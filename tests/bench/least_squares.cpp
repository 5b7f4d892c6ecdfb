#include "tests/bench/least_squares.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace boxprobe::bench {

namespace {

using Vector = std::vector<double>;

double sumOfSquares(const Vector& v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  return sum;
}

double product(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// By Cholesky's decomposition; false where the matrix is not positive definite.
bool solve(std::vector<Vector> m, Vector& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      if (i == j && sum <= 0.0) return false;
      m[i][j] = i == j ? std::sqrt(sum) : sum / m[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= m[k][i] * x[k];
    x[i] /= m[i][i];
  }
  return true;
}

}  // namespace

double leastSquares(const Residuals& residuals, Vector& constants, int rounds) {
  constexpr double kDifference = 0.01;  // above the kinks of trilinear lookups, below what changes a constant's effect
  constexpr double kLongestStep = 0.3;
  const std::size_t n = constants.size();
  Vector now = residuals(constants);
  double least = sumOfSquares(now), damping = 0.01;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vector> slopes(n);
    for (std::size_t i = 0; i < n; ++i) {
      Vector moved = constants;
      moved[i] += kDifference;
      slopes[i] = residuals(moved);
      for (std::size_t k = 0; k < now.size(); ++k) slopes[i][k] = (slopes[i][k] - now[k]) / kDifference;
    }
    std::vector<Vector> matrix(n, Vector(n));
    Vector downhill(n);
    tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) {
      for (std::size_t j = 0; j < n; ++j) matrix[i][j] = product(slopes[i], slopes[j]);
      downhill[i] = -product(slopes[i], now);
    });
    const double before = least;
    for (int attempt = 0; attempt < 6 && least == before; ++attempt) {
      std::vector<Vector> damped = matrix;
      for (std::size_t i = 0; i < n; ++i) damped[i][i] += damping * matrix[i][i] + 1e-9;
      Vector step = downhill, moved = constants;
      if (solve(damped, step)) {
        for (std::size_t i = 0; i < n; ++i) moved[i] += std::clamp(step[i], -kLongestStep, kLongestStep);
        Vector there = residuals(moved);
        if (const double sum = sumOfSquares(there); sum < least) {
          least = sum;
          constants = std::move(moved);
          now = std::move(there);
          damping = std::max(0.3 * damping, 1e-5);
          continue;
        }
      }
      damping *= 4.0;
    }
    if (before - least < 1e-5 * before) break;
  }
  return least;
}

}  // namespace boxprobe::bench
