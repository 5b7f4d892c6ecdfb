#include "filters/reference/truth/truth_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/reference/measure/error_tally.h"
#include "filters/reference/trace/picture_rays.h"

namespace boxprobe {

namespace {

// Half precision represents 1 exactly; anything less is an edge pixel.
constexpr float kCovered = 0.9995f;
// Narrower at low angles, where the lobe changes fastest. The last bucket includes 1.
constexpr std::array<double, 7> kEdges = {0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0};

glm::dvec3 colorAt(const ImageRgbaF& image, std::size_t pixel) {
  const float* p = &image.pixels[4 * pixel];
  return {p[0], p[1], p[2]};
}

bool counts(const ImageRgbaF& truth, const ImageRgbaF& drawn, std::size_t pixel) {
  return coveredByFloor(truth, pixel) && coveredByFloor(drawn, pixel);
}

/// The RMS of a per-pixel difference, relative to that of the light.
template <typename Difference>
double relativeOnFloor(const ImageRgbaF& truth, const ImageRgbaF& drawn, const Difference& difference) {
  double squares = 0.0, light = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size() / 4; ++i) {
    if (!counts(truth, drawn, i)) continue;
    const glm::dvec3 d = difference(i), color = colorAt(truth, i);
    squares += glm::dot(d, d);
    light += glm::dot(color, color);
  }
  return light > 0.0 ? std::sqrt(squares / light) : 0.0;
}

/// `ofTruth`: relative RMS. Channels are assumed to err alike, as the reference's do, which gives the largest error of
/// a mean.
void setNoise(TruthRow& row, const ImageRgbaF& truth, const ImageRgbaF& drawn, const ImageRgbaF* standardError,
              double ofTruth) {
  double squares = 0.0, sum = 0.0, noise = 0.0, sumNoise = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size() / 4; ++i) {
    if (!counts(truth, drawn, i)) continue;
    const glm::dvec3 color = colorAt(truth, i);
    squares += glm::dot(color, color);
    sum += color.x + color.y + color.z;
    if (standardError == nullptr) continue;
    const glm::dvec3 error = colorAt(*standardError, i);
    noise += glm::dot(error, error);
    sumNoise += std::pow(error.x + error.y + error.z, 2.0);
  }
  if (!(sum > 0.0)) return;
  row.noise = std::hypot(ofTruth, std::sqrt(noise / squares));
  row.lightNoise = std::hypot(ofTruth * std::sqrt(3.0 * squares), std::sqrt(sumNoise)) / sum;
}

}  // namespace

bool coveredByFloor(const ImageRgbaF& truth, std::size_t pixel) {
  return truth.pixels[4 * pixel + 3] >= kCovered;
}

bool TruthRow::holds() const {
  return std::abs(meanLight - 1.0) <= largestLightError() && relativeRmse <= largestRmse();
}

TruthRow compareWithTruth(const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                          const std::string& technique, const ImageRgbaF& drawn, const ImageRgbaF* standardError) {
  const ImageRgbaF truth = loadTruthPicture(index, picture);
  if (drawn.width != truth.width || drawn.height != truth.height) {
    throw InputError(picture.file + ": compared with a picture of another size");
  }
  TruthRow row;
  row.scene = picture.scene;
  row.camera = picture.camera;
  row.kind = picture.kind;
  row.roughness = picture.roughness;
  row.technique = technique;
  ErrorTally all;
  std::array<ErrorTally, kEdges.size() - 1> byAngle;
  const PictureRays rays(camera, truth.width, truth.height);
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.width) + static_cast<std::size_t>(x);
      if (!counts(truth, drawn, pixel)) continue;
      const glm::dvec3 value = colorAt(drawn, pixel), right = colorAt(truth, pixel);
      all.add(value, right, 0.0);
      const double nDotV = -glm::normalize(rays.direction(x + 0.5, y + 0.5)).y;  // the floor is horizontal
      std::size_t bucket = 0;
      while (bucket + 1 < byAngle.size() && nDotV >= kEdges[bucket + 1]) ++bucket;
      byAngle[bucket].add(value, right, 0.0);
    }
  }
  if (all.pixels() == 0) throw InputError(picture.file + ": shows no floor");
  setNoise(row, truth, drawn, standardError, picture.noise);
  row.meanLight = all.brightnessRatio();
  row.relativeRmse = all.relativeRmse();
  row.pixels = all.pixels();
  for (std::size_t i = 0; i < byAngle.size(); ++i) {
    if (byAngle[i].pixels() == 0) continue;
    row.buckets.push_back(
        {kEdges[i], kEdges[i + 1], byAngle[i].brightnessRatio(), byAngle[i].relativeRmse(), byAngle[i].pixels()});
  }
  return row;
}

double texelCost(const ReferencePicture& picture, const ReferencePicture& coarser, const ImageRgbaF& truth) {
  return relativeOnFloor(truth, picture.color,
                         [&](std::size_t i) { return colorAt(picture.color, i) - colorAt(coarser.color, i); });
}

ImageRgbaF boxAveraged(const ImageRgbaF& fine, int factor) {
  ImageRgbaF image{fine.width / factor, fine.height / factor, {}};
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const auto fineWidth = static_cast<std::size_t>(fine.width), side = static_cast<std::size_t>(factor);
  image.pixels.resize(width * height * 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::size_t x = i / 4 % width, y = i / 4 / width;
    double sum = 0.0;
    for (std::size_t k = 0; k < side * side; ++k) {
      sum += fine.pixels[((y * side + k / side) * fineWidth + x * side + k % side) * 4 + i % 4];
    }
    image.pixels[i] = static_cast<float>(sum / static_cast<double>(side * side));
  }
  return image;
}

}  // namespace boxprobe
