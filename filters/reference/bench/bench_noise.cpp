#include "filters/reference/bench/bench_noise.h"

#include <cmath>
#include <complex>

namespace boxprobe {

namespace {

using Complex = std::complex<double>;

/// In-place FFT of values `stride` apart; `count` is a power of two (Cooley and Tukey 1965).
void transform(Complex* values, std::size_t count, std::size_t stride) {
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i * stride], values[j * stride]);
  }
  for (std::size_t length = 2; length <= count; length <<= 1) {
    const Complex step = std::polar(1.0, -2.0 * M_PI / static_cast<double>(length));
    for (std::size_t start = 0; start < count; start += length) {
      Complex turn(1.0, 0.0);
      for (std::size_t k = 0; k < length / 2; ++k, turn *= step) {
        Complex& low = values[(start + k) * stride];
        Complex& high = values[(start + k + length / 2) * stride];
        const Complex odd = turn * high;
        high = low - odd;
        low += odd;
      }
    }
  }
}

std::size_t powerOfTwo(int least) {
  std::size_t size = 1;
  while (size < static_cast<std::size_t>(least)) size <<= 1;
  return size;
}

double lowFrequencyShare(const std::vector<float>& error, int width, int height) {
  const std::size_t columns = powerOfTwo(width), rows = powerOfTwo(height);
  std::vector<Complex> values(columns * rows);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      values[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] =
          error[static_cast<std::size_t>(y * width + x)];
    }
  }
  for (std::size_t y = 0; y < rows; ++y) transform(&values[y * columns], columns, 1);
  for (std::size_t x = 0; x < columns; ++x) transform(&values[x], rows, columns);
  // An eighth of a cycle per pixel: waves of 8 pixels and longer.
  constexpr double kLow = 0.125;
  const auto frequency = [](std::size_t i, std::size_t count) {
    const double f = static_cast<double>(i) / static_cast<double>(count);
    return f > 0.5 ? f - 1.0 : f;
  };
  double low = 0.0, all = 0.0;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const double power = std::norm(values[y * columns + x]);
      all += power;
      if (std::hypot(frequency(x, columns), frequency(y, rows)) < kLow) low += power;
    }
  }
  return all > 0.0 ? low / all : 0.0;
}

double errorAfterBlur(const std::vector<float>& error, const std::vector<bool>& mask, int width, int height) {
  double squares = 0.0;
  std::size_t pixels = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!mask[static_cast<std::size_t>(y * width + x)]) continue;
      double sum = 0.0;
      int count = 0;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          const auto at = static_cast<std::size_t>(v * width + u);
          if (!mask[at]) continue;
          sum += error[at];
          ++count;
        }
      }
      squares += sum / count * sum / count;
      ++pixels;
    }
  }
  return pixels > 0 ? std::sqrt(squares / static_cast<double>(pixels)) : 0.0;
}

}  // namespace

NoiseFigures noiseFigures(const std::vector<float>& error, const std::vector<bool>& mask, int width, int height) {
  return {lowFrequencyShare(error, width, height), errorAfterBlur(error, mask, width, height)};
}

}  // namespace boxprobe
