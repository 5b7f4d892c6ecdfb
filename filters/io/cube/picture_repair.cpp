#include "filters/io/cube/picture_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "filters/core/base/number_text.h"
#include "filters/io/cube/picture_sphere.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMostSuns = 16;  // each costs a few passes over the picture

/// The sums of the finite channels among the eight neighbours, and how many each has.
struct Neighbours {
  std::array<double, 3> sum{};
  std::array<int, 3> count{};
};

Neighbours neighboursOf(const std::vector<float>& pixels, const ImageRgbaF& image, int column, int row, bool wraps) {
  Neighbours around;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, image.height - 1); ++y) {
    for (int step = -1; step <= 1; ++step) {
      int x = column + step;
      if (wraps) x = (x + image.width) % image.width;
      if (x < 0 || x >= image.width || (step == 0 && y == row)) continue;
      const float* rgba = &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(x))];
      for (std::size_t c = 0; c < 3; ++c) {
        if (!std::isfinite(rgba[c])) continue;
        around.sum[c] += rgba[c];
        ++around.count[c];
      }
    }
  }
  return around;
}

float meanOf(const Neighbours& around, std::size_t channel) {
  return around.count[channel] > 0 ? static_cast<float>(around.sum[channel] / around.count[channel]) : 0.0f;
}

/// The neighbours' hue at the brightness of the channels that are numbers.
void fillNan(float* rgb, const Neighbours& around) {
  float own = 0.0f, others = 0.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::isnan(rgb[c]) || around.count[c] == 0) continue;
    own += rgb[c];
    others += meanOf(around, c);
  }
  const float scale = own > 0.0f && others > 0.0f ? std::min(own / others, kMostRadiance) : 1.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::isnan(rgb[c])) rgb[c] = std::clamp(meanOf(around, c) * scale, 0.0f, kMostRadiance);
  }
}

struct Sun {
  glm::dvec3 direction{0.0}, energy{0.0};
};

/// `Sphere`: picture_sphere.h.
template <typename Sphere>
class Spreading {
 public:
  Spreading(const Sphere& sphere, PictureRepairs& repairs) : sphere_(sphere), repairs_(repairs) {}

  void run() {
    findSuns();
    if (suns_.empty()) return;
    cutOff();
    glm::dvec3 lost(0.0), all(0.0);
    for (const Sun& sun : suns_) {
      all += sun.energy;
      if (!spread(sun)) lost += sun.energy;
    }
    for (std::size_t i = 0; i < sphere_.count; ++i) all += sphere_.solidAngle(i) * rgb(i);
    const double total = all.x + all.y + all.z;
    if (total > 0.0) repairs_.lightLost = std::max(repairs_.lightLost, (lost.x + lost.y + lost.z) / total);
  }

 private:
  glm::dvec3 rgb(std::size_t i) const {
    const float* from = sphere_.rgba(i);
    return {from[0], from[1], from[2]};
  }
  bool beyond(std::size_t i) const { return brightestChannel(sphere_.rgba(i)) > kHalfMax; }
  /// What a texel has above the largest half float, at its hue, times its solid angle.
  glm::dvec3 excess(std::size_t i) const {
    return sphere_.solidAngle(i) * (1.0 - static_cast<double>(kHalfMax) / brightestChannel(sphere_.rgba(i))) * rgb(i);
  }

  /// Texels beyond the limit that lie near each other are one sun, in the direction of its energy's centre.
  void findSuns() {
    const double kOneSun = std::cos(3.0 * kPi / 180.0);
    std::vector<glm::dvec3> seeds;
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      if (!beyond(i)) continue;
      const glm::dvec3 direction = sphere_.direction(i), energy = excess(i);
      auto seed = std::find_if(seeds.begin(), seeds.end(),
                               [&](const glm::dvec3& s) { return glm::dot(s, direction) > kOneSun; });
      if (seed == seeds.end() && seeds.size() < kMostSuns) {
        seeds.push_back(direction);
        suns_.emplace_back();
        seed = seeds.end() - 1;
      } else if (seed == seeds.end()) {  // too many to be suns: to the nearest
        seed = std::max_element(seeds.begin(), seeds.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
          return glm::dot(a, direction) < glm::dot(b, direction);
        });
      }
      Sun& sun = suns_[static_cast<std::size_t>(seed - seeds.begin())];
      sun.energy += energy;
      sun.direction += (energy.x + energy.y + energy.z) * direction;
    }
    for (std::size_t i = 0; i < suns_.size(); ++i) {
      const double length = glm::length(suns_[i].direction);
      suns_[i].direction = length > 0.0 ? suns_[i].direction / length : seeds[i];
    }
  }

  void cutOff() {
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      if (!beyond(i)) continue;
      float* to = sphere_.rgba(i);
      const float scale = kHalfMax / brightestChannel(to);
      for (int c = 0; c < 3; ++c) to[c] = std::min(to[c] * scale, kHalfMax);
    }
  }

  /// How much light of the brightest channel the disc takes up.
  double room(const glm::dvec3& direction, double cosine) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      if (glm::dot(sphere_.direction(i), direction) < cosine) continue;
      sum += sphere_.solidAngle(i) * std::max(kHalfMax - brightestChannel(sphere_.rgba(i)), 0.0f);
    }
    return sum;
  }

  bool spread(const Sun& sun) {
    const double most = std::max({sun.energy.x, sun.energy.y, sun.energy.z});
    if (!(most > 0.0)) return true;
    // A disc of 2 pi (1 - cos) steradians at the limit holds it if all else is dark; it grows until it does.
    const double kLeastCosine = std::cos(30.0 * kPi / 180.0);
    constexpr double kFewTexels = 10.0;
    double share = std::max(most / (2.0 * kPi * kHalfMax), kFewTexels / static_cast<double>(sphere_.count)), free = 0.0;
    for (;; share *= 1.15) {
      if (1.0 - share < kLeastCosine) return false;
      free = room(sun.direction, 1.0 - share);
      if (free >= most) break;
    }
    const double filled = most / free;
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      if (glm::dot(sphere_.direction(i), sun.direction) < 1.0 - share) continue;
      float* to = sphere_.rgba(i);
      const double taken = filled * std::max(kHalfMax - brightestChannel(to), 0.0f) / most;
      for (int c = 0; c < 3; ++c) {
        to[c] = std::min(static_cast<float>(to[c] + taken * sun.energy[c]), kHalfMax);
      }
    }
    return true;
  }

  const Sphere& sphere_;
  PictureRepairs& repairs_;
  std::vector<Sun> suns_;
};

}  // namespace

void repairNotFinite(ImageRgbaF& image, bool wraps, PictureRepairs& repairs) {
  std::vector<std::size_t> bad;
  for (std::size_t texel = 0; texel < image.pixels.size(); texel += 4) {
    const float* rgba = &image.pixels[texel];
    if (!std::all_of(rgba, rgba + 4, [](float v) { return std::isfinite(v); })) bad.push_back(texel);
  }
  repairs.notFinite += bad.size();
  // Neighbours are looked at as the file has them, not as repaired before.
  std::vector<std::array<float, 4>> repaired(bad.size());
  for (std::size_t i = 0; i < bad.size(); ++i) {
    std::array<float, 4>& rgba = repaired[i];
    std::copy_n(&image.pixels[bad[i]], 4, rgba.begin());
    float most = kHalfMax;
    for (std::size_t c = 0; c < 3; ++c) most = std::isfinite(rgba[c]) ? std::max(most, rgba[c]) : most;
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::isinf(rgba[c])) rgba[c] = rgba[c] > 0.0f ? most : 0.0f;
    }
    if (!std::isfinite(rgba[3])) rgba[3] = 1.0f;
    if (std::none_of(rgba.begin(), rgba.end(), [](float v) { return std::isnan(v); })) continue;
    const auto texel = static_cast<int>(bad[i] / 4);
    fillNan(rgba.data(), neighboursOf(image.pixels, image, texel % image.width, texel / image.width, wraps));
  }
  for (std::size_t i = 0; i < bad.size(); ++i) std::copy_n(repaired[i].begin(), 4, &image.pixels[bad[i]]);
}

void limitRadiance(ImageRgbaF& image, PictureRepairs& repairs) {
  for (std::size_t texel = 0; texel < image.pixels.size(); texel += 4) {
    float* rgba = &image.pixels[texel];
    const float most = brightestChannel(rgba);
    if (most > kHalfMax) ++repairs.beyondHalf;
    if (std::min({rgba[0], rgba[1], rgba[2]}) < 0.0f) ++repairs.negative;
    const float scale = most > kMostRadiance ? kMostRadiance / most : 1.0f;
    for (int c = 0; c < 3; ++c) rgba[c] = std::clamp(rgba[c] * scale, 0.0f, kMostRadiance);
    rgba[3] = std::clamp(rgba[3], 0.0f, kHalfMax);
  }
}

void spreadBeyondHalf(ImageRgbaF& image, PictureRepairs& repairs) {
  if (repairs.beyondHalf == 0) return;
  const LatLongSphere sphere(image);
  Spreading(sphere, repairs).run();
}

void spreadBeyondHalf(CubeMap& cube, PictureRepairs& repairs) {
  if (repairs.beyondHalf == 0) return;
  const CubeSphere sphere(cube);
  Spreading(sphere, repairs).run();
}

std::vector<std::string> PictureRepairs::sentences() const {
  std::vector<std::string> texts = remarks;
  const auto texels = [](std::size_t count) {
    return std::to_string(count) + (count == 1 ? " texel is " : " texels are ");
  };
  if (notFinite > 0) {
    texts.push_back(texels(notFinite) + "NaN or infinite: filled in, infinity as 65504, NaN in its neighbours' hue");
  }
  if (negative > 0) texts.push_back(texels(negative) + "negative in a channel, which counts as 0");
  if (beyondHalf > 0) {
    std::string text = texels(beyondHalf) + "above 65504, the largest half float: ";
    // Cut at a tenth of a percent, so that a trace of light is told as one.
    const double percent = std::ceil(1000.0 * lightLost) / 10.0;
    text += lightLost > 0.0 ? numberText(percent) + " % of the picture's light is cut off"
                            : "the light was spread over the directions around";
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace boxprobe
