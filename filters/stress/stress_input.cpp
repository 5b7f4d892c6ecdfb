// See stress_input.h.
#include "filters/stress/stress_input.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <stdexcept>

namespace boxprobe::stress {

namespace {

// Visits every number of an input once, so that printing and parsing use the same list.
template <typename Input, typename Visit>
void eachVector(Input& in, const Visit& visit) {
  visit("origin", in.originWorld);
  visit("boxMin", in.boxMinWorld);
  visit("boxMax", in.boxMaxWorld);
  visit("position", in.positionWorld);
  visit("normal", in.normal);
  visit("view", in.view);
  visit("reflection", in.reflection);
  visit("turn", in.turn);
}

template <typename Input, typename Visit>
void eachNumber(Input& in, const Visit& visit) {
  visit("roughness", in.roughness);
  visit("maxLevel", in.maxLevel);
  visit("blendDistance", in.blendDistance);
  visit("bevel", in.bevel);
}

template <typename Input, typename Visit>
void eachWhole(Input& in, const Visit& visit) {
  visit("pixelX", in.pixel.x);
  visit("pixelY", in.pixel.y);
  visit("frame", in.frame);
}

}  // namespace

// Rodrigues' formula in double, rounded once.
glm::mat3 worldFromProbe(const glm::vec3& turn) {
  const glm::dvec3 v(turn);
  const double angle = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  if (!(angle > 0.0) || !std::isfinite(angle)) return glm::mat3(1.0f);
  const glm::dvec3 a = v / angle;
  const double c = std::cos(angle), s = std::sin(angle), k = 1.0 - c;
  return glm::mat3(glm::dmat3(c + k * a.x * a.x, k * a.x * a.y + s * a.z, k * a.x * a.z - s * a.y,
                              k * a.x * a.y - s * a.z, c + k * a.y * a.y, k * a.y * a.z + s * a.x,
                              k * a.x * a.z + s * a.y, k * a.y * a.z - s * a.x, c + k * a.z * a.z));
}

LocalInput unguardedInput(const StressInput& in) {
  LocalInput local;
  local.probe.boxMin = in.boxMinWorld - in.originWorld;
  local.probe.boxMax = in.boxMaxWorld - in.originWorld;
  local.probe.maxLevel = in.maxLevel;
  local.probe.bevel = in.bevel;
  local.probe.parameters = in.parameters;
  local.point = {in.positionWorld - in.originWorld,
                 in.normal,
                 in.view,
                 in.reflection,
                 in.roughness,
                 in.pixel,
                 in.frame,
                 in.roughness,  // reflectances: any values work
                 1.0f};
  if (in.turn != glm::vec3(0.0f)) {
    const glm::mat3 probeFromWorld = glm::transpose(worldFromProbe(in.turn));
    for (glm::vec3* v : {&local.point.position, &local.point.normal, &local.point.view, &local.point.reflection}) {
      *v = probeFromWorld * *v;
    }
  }
  return local;
}

LocalInput localInput(const StressInput& in) {
  LocalInput local = unguardedInput(in);
  shading::ShadingPoint& p = local.point;
  const glm::vec3 given = p.reflection;
  p.position = shading::finiteOr(p.position, glm::vec3(0.0f));
  p.view = shading::directionOr(p.view, glm::vec3(0.0f, 0.0f, 1.0f));
  p.normal = shading::directionOr(p.normal, p.view);
  p.roughness = shading::roughnessWithin(p.roughness);
  p.fresnel = shading::roughnessWithin(p.fresnel);
  p.f0 = std::max(p.roughness, 1.0e-2f);
  // Inputs contain R itself, so that its components can be exactly what a class needs. If any of the three is broken, R
  // is computed from N and V.
  p.reflection = shading::directionOr(given, shading::reflectedView(p.normal, p.view));
  return local;
}

std::vector<std::string> numberNames(const std::vector<const ParameterRow*>& parameters) {
  std::vector<std::string> names;
  const StressInput in;
  eachVector(in, [&](const char* name, const glm::vec3&) {
    for (const char* axis : {".x", ".y", ".z"}) names.push_back(std::string(name) + axis);
  });
  eachNumber(in, [&](const char* name, float) { names.emplace_back(name); });
  eachWhole(in, [&](const char* name, int) { names.emplace_back(name); });
  for (const ParameterRow* row : parameters) names.emplace_back(row->name);
  return names;
}

std::vector<float> numbersOf(const StressInput& in, const std::vector<const ParameterRow*>& parameters) {
  std::vector<float> numbers;
  eachVector(in, [&](const char*, const glm::vec3& v) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(v[axis]);
  });
  eachNumber(in, [&](const char*, float v) { numbers.push_back(v); });
  eachWhole(in, [&](const char*, int v) { numbers.push_back(static_cast<float>(v)); });
  for (const ParameterRow* row : parameters) {
    if (row->number != nullptr) {
      numbers.push_back(in.parameters.*row->number);
    } else {
      numbers.push_back(row->choice != nullptr ? static_cast<float>(in.parameters.*row->choice) : 0.0f);
    }
  }
  return numbers;
}

StressInput inputFrom(const std::vector<float>& numbers, const std::vector<const ParameterRow*>& parameters) {
  const std::size_t expected = numberNames(parameters).size();
  if (numbers.size() != expected) {
    throw std::invalid_argument("expected " + std::to_string(expected) + " numbers, not " +
                                std::to_string(numbers.size()));
  }
  StressInput in;
  auto next = numbers.begin();
  eachVector(in, [&](const char*, glm::vec3& v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = *next++;
  });
  eachNumber(in, [&](const char*, float& v) { v = *next++; });
  eachWhole(in, [&](const char*, int& v) { v = static_cast<int>(*next++); });
  for (const ParameterRow* row : parameters) {
    const float value = *next++;
    if (row->number != nullptr) in.parameters.*row->number = value;
    if (row->choice != nullptr) in.parameters.*row->choice = static_cast<int>(value);
  }
  return in;
}

double boxSize(const shading::ProbeShape& probe, const glm::vec3& position) {
  const glm::dvec3 size = glm::dvec3(probe.boxMax) - glm::dvec3(probe.boxMin);
  const double side = std::max({size.x, size.y, size.z});
  if (side > 0.0) return side;
  const glm::dvec3 off = glm::dvec3(position) - glm::dvec3(probe.boxMin);
  const double distance = std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)});
  return distance > 0.0 ? distance : 1.0;
}

}  // namespace boxprobe::stress
