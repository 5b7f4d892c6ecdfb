#include "filters/math/technique/technique_errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "filters/math/technique/parameter_table.h"

namespace boxprobe {

using glm::vec3;
using glm::vec4;

namespace {

constexpr int kPoints = 128;  // per roughness
constexpr float kRays = 128.0f;
// A picture shows a part of the box, so its error scatters about the box's. In random rooms a tenth more costs as much
// as the best choice in hindsight, and leaves half as many rooms beyond the budget as the table does; a fifth more
// leaves a third and costs a quarter more.
constexpr double kScatter = 1.1;

float fraction(int i, double step) {
  return static_cast<float>(std::fmod(0.5 + i * step, 1.0));
}

vec3 onSphere(float u, float v) {
  const float z = 2.0f * u - 1.0f, r = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = 6.2831853f * v;
  return {r * std::cos(phi), z, r * std::sin(phi)};
}

// Half of the points on floors, a quarter on walls, a quarter anywhere inside, with views from every angle. Quasirandom
// (Roberts 2018), so a hundred points are enough.
shading::ShadingPoint pointAt(const shading::ProbeShape& probe, int i, float roughness) {
  const vec3 low = probe.boxMin, size = probe.boxMax - probe.boxMin;
  const vec3 at(fraction(i, 0.8566748838545029), fraction(i, 0.7338918566271260), fraction(i, 0.6287067210378087));
  shading::ShadingPoint point{};
  point.position = low + (0.06f + 0.88f * at) * size;
  vec3 normal(0.0f, 1.0f, 0.0f);
  const int kind = i % 4;
  if (kind == 1) {
    const int axis = (i / 4) % 2 == 0 ? 0 : 2;
    const bool high = (i / 8) % 2 == 1;
    point.position[axis] = high ? probe.boxMax[axis] : low[axis];
    normal = vec3(0.0f);
    normal[axis] = high ? -1.0f : 1.0f;
  } else if (kind == 3) {
    normal = onSphere(fraction(i, 0.5385972572236101), fraction(i, 0.4613977270545880));
  } else {
    point.position.y = low.y;
  }
  const float cosine = 0.05f + 0.93f * fraction(i, 0.5497004779019703);
  vec3 side = onSphere(fraction(i, 0.3027756377319946), fraction(i, 0.2360679774997896));
  side = side - glm::dot(side, normal) * normal;
  if (glm::dot(side, side) < 1.0e-6f) side = vec3(normal.y, normal.z, normal.x);  // a direction along N has no side
  side = glm::normalize(side - glm::dot(side, normal) * normal);
  point.normal = normal;
  point.view = glm::normalize(cosine * normal + std::sqrt(1.0f - cosine * cosine) * side);
  point.reflection = shading::reflectedView(point.normal, point.view);
  point.roughness = roughness;
  point.fresnel = roughness;
  point.f0 = (i / 16) % 2 == 0 ? 1.0f : 0.04f;  // a metal, a non-metal
  point.pixel = glm::ivec2(i % 16, i / 16);
  return point;
}

double shown(float x) {
  const double linear = std::max(static_cast<double>(x), 0.0);
  return std::pow(linear / (1.0 + linear), 1.0 / 2.2);
}

double squareOf(const vec4& value, const vec4& truth) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += std::pow(shown(value[k]) - shown(truth[k]), 2.0) / 3.0;
  return sum;
}

}  // namespace

TechniqueErrors measureTechniqueErrors(const shading::CubeSampler& chain, const shading::ProbeShape& probe) {
  const auto& candidates = measuredTechniques();
  const auto& nodes = measuredRoughness();
  TechniqueErrors result(candidates.size());
  const Technique rays = parseTechnique("box+raytraced").value();
  const auto value = [&](const Technique& technique, const shading::TechniqueParameters& parameters,
                         const shading::ShadingPoint& point) {
    shading::ProbeShape shape = probe;
    shape.projection = technique.projection;
    shape.parameters = parameters;
    return evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate(&chain, shape, point);
  };
  const shading::TechniqueParameters standard = standardParameters();
  shading::TechniqueParameters many = standard;
  many.samples = kRays;
  many.filtered = 1;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (nodes[node] == 0.0) continue;  // a mirror: all techniques sample the same
    std::vector<std::vector<double>> squares(kPoints, std::vector<double>(candidates.size()));
    tbb::parallel_for(0, kPoints, [&](int i) {
      const shading::ShadingPoint point = pointAt(probe, i, static_cast<float>(nodes[node]));
      const vec4 truth = value(rays, many, point);
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        const auto technique = parseTechnique(candidates[k].id);
        if (technique) squares[static_cast<std::size_t>(i)][k] = squareOf(value(*technique, standard, point), truth);
      }
    });
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      double sum = 0.0;
      for (const auto& ofPoint : squares) sum += ofPoint[k];
      result[k][node] = kScatter * std::sqrt(sum / kPoints);
    }
  }
  return result;
}

}  // namespace boxprobe
