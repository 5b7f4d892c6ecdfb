// A probe's maps for the stress test, computed on the fly; they check their lookups. Smooth, so that CPU and GPU can be
// compared; shaders/stress/echo.glsl is the GPU version. One per input; not thread-safe.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/cube/relief.h"
#include "filters/math/shared/shared_math.h"
#include "filters/stress/stress_light.h"
#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

class StressMap : public shading::CubeSampler, public shading::DistanceSampler, public shading::ReliefSampler {
 public:
  explicit StressMap(const shading::ProbeShape& probe) : probe_(probe) {
    blocks_.count = 2;
    for (std::size_t i = 0; i < 2; ++i) {
      const glm::vec3 size = probe.boxMax - probe.boxMin;
      blocks_.low[i] = probe.boxMin + (i == 0 ? 0.1f : 0.6f) * size;
      blocks_.high[i] = blocks_.low[i] + (i == 0 ? 0.2f : 0.4f) * size;
    }
  }

  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    ++lookups_;
    level_ = level;
    const bool inChain = level >= 0.0f && level <= probe_.maxLevel;
    const float size = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    const bool directed = size >= 1.0e-37f && std::isfinite(size);
    unusable_ += inChain && directed ? 0 : 1;
    return glm::vec4(direction / largest(direction), level);
  }

  /// The box's walls as seen from the capture origin, uneven, with a hole towards +Z where nothing was seen.
  float fetchDistance(const glm::vec3& direction) const override {
    const glm::vec3 q = direction / largest(direction);
    if (q.z > 0.9f) return 0.0f;
    const glm::vec3 walls = shading::slabFactors(glm::vec3(0.0f), q, probe_.boxMin, probe_.boxMax);
    const float t = std::min(std::min(walls.x, walls.y), walls.z);
    return std::min(t, 1.0e30f) * glm::length(q) * (0.8f + 0.2f * q.x * q.y);
  }

  /// Planes perpendicular to the directions of those distances; what is far lies upwards only. From level 1 on blocks
  /// are half as deep.
  glm::vec4 fetchRelief(const glm::vec3& direction, float level) const override {
    const glm::vec3 q = direction / largest(direction);
    const float seen = fetchDistance(direction);
    const glm::vec3 plane = seen > 1.0e-30f ? q / (glm::length(q) * seen) : glm::vec3(0.0f);
    if (level > 0.5f) return glm::vec4(plane, seen > 1.0e-30f ? 0.5f * level / seen : 0.0f);
    return glm::vec4(plane, q.z > 0.9f ? Relief::kHere : q.x > 0.9f ? Relief::kNowhere : 4096.0f * 2048.0f + 2048.0f);
  }

  float reliefSize() const override { return 64.0f; }

  shading::ProbeData probeData() const {
    shading::ProbeData data;
    data.relief = this;
    data.blocks = &blocks_;
    data.light = &stressLightTable();
    return data;
  }
  int lookups() const { return lookups_; }
  int unusable() const { return unusable_; }
  bool usable() const { return unusable_ == 0; }
  float level() const { return level_; }  ///< of the last lookup

 private:
  static float largest(const glm::vec3& d) {
    return std::max(std::max(std::abs(d.x), std::abs(d.y)), std::max(std::abs(d.z), 1.0e-37f));
  }

  const shading::ProbeShape& probe_;
  ReliefBlocks blocks_;
  mutable int lookups_ = 0, unusable_ = 0;
  mutable float level_ = 0.0f;
};

/// Logs a technique's inputs for the replay.
inline void logLocal(const LocalInput& in, TrialLog& log) {
  log.add("box min (probe frame)", in.probe.boxMin);
  log.add("box max (probe frame)", in.probe.boxMax);
  log.add("P (probe frame)", in.point.position);
  log.add("N", in.point.normal);
  log.add("V", in.point.view);
  log.add("R", in.point.reflection);
  log.add("N.V", static_cast<double>(glm::dot(in.point.normal, in.point.view)));
  log.add("roughness", static_cast<double>(in.point.roughness));
}

}  // namespace boxprobe::stress
