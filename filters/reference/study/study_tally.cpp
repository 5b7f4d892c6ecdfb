#include "filters/reference/study/study_tally.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "filters/math/technique/technique_table.h"

namespace boxprobe::study {

using glm::dvec3;

double displayValue(double radiance) {
  const double x = std::max(radiance, 0.0);
  return std::pow(x / (1.0 + x), 1.0 / 2.2);
}

Technique techniqueOf(const char* id) {
  const boxprobe::Technique technique = parseTechnique(id).value();
  const auto evaluate = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate;
  return [=](const RoomPoint& p) {
    shading::ProbeShape probe = p.probe;
    probe.projection = technique.projection;
    return dvec3(evaluate(p.chain, probe, p.point));
  };
}

std::vector<dvec3> valuesOf(const Technique& technique, const std::vector<RoomPoint>& points) {
  std::vector<dvec3> values(points.size());
  tbb::parallel_for(std::size_t(0), points.size(), [&](std::size_t i) { values[i] = technique(points[i]); });
  return values;
}

double TechniqueTally::worstLight() const {
  double worst = 0.0;
  for (const double l : light) worst = std::max(worst, std::abs(l - 1.0));
  return worst;
}

std::size_t TechniqueTally::mostOff() const {
  const auto off = [](double a, double b) { return std::abs(a - 1.0) < std::abs(b - 1.0); };
  return static_cast<std::size_t>(std::max_element(light.begin(), light.end(), off) - light.begin());
}

TechniqueTally tally(const std::vector<dvec3>& values, const std::vector<RoomPoint>& points) {
  std::array<double, kRoughnesses> squares{}, counts{};
  std::array<double, kBuckets> truthLight{};
  double linearSquares = 0.0, truthSquares = 0.0;
  struct Light {
    double value = 0.0, truth = 0.0;
  };
  std::map<const PaddedCube*, std::array<Light, kBuckets>> rooms;
  TechniqueTally result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto r = static_cast<std::size_t>(points[i].roughness);
    const std::size_t bucket = r * kAngles + static_cast<std::size_t>(points[i].angle);
    for (int c = 0; c < 3; ++c) {
      const double value = values[i][c], truth = points[i].truth[c];
      squares[r] += std::pow(displayValue(value) - displayValue(truth), 2.0);
      counts[r] += 1.0;
      linearSquares += (value - truth) * (value - truth);
      truthSquares += truth * truth;
      result.light[bucket] += value;
      truthLight[bucket] += truth;
      Light& light = rooms[points[i].chain][bucket];
      light.value += value;
      light.truth += truth;
    }
  }
  double allSquares = 0.0, all = 0.0;
  for (std::size_t r = 0; r < kRoughnesses; ++r) {
    result.rmseByRoughness[r] = std::sqrt(squares[r] / std::max(counts[r], 1.0));
    allSquares += squares[r];
    all += counts[r];
  }
  for (std::size_t b = 0; b < kBuckets; ++b)
    result.light[b] = truthLight[b] > 0.0 ? result.light[b] / truthLight[b] : 1;
  // Standard error of a ratio of two sums over rooms.
  for (const auto& [room, lights] : rooms) {
    for (std::size_t b = 0; b < kBuckets; ++b) {
      if (truthLight[b] > 0.0)
        result.lightError[b] += std::pow((lights[b].value - result.light[b] * lights[b].truth) / truthLight[b], 2.0);
    }
  }
  const auto count = static_cast<double>(rooms.size());
  for (double& error : result.lightError) error = std::sqrt(error * count / std::max(count - 1.0, 1.0));
  result.rmse = std::sqrt(allSquares / all);
  result.relativeRmse = std::sqrt(linearSquares / truthSquares);
  return result;
}

}  // namespace boxprobe::study
