// GLSL and C++ versions of the stress test's subjects: one program per technique or term.
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <string>

#include "filters/stress/stress_trial.h"

namespace boxprobe {

/// Two vectors per pixel: for a technique the lookup and (hit, distance), for a term its value.
struct StressValues {
  glm::vec4 value{0.0f}, hit{0.0f};
};

struct StressProgram {
  std::string declarations;  ///< functions before main()
  std::string body;          ///< reads `probe`, `point` and `extra`, writes `out0` and `out1`
  std::function<StressValues(const stress::StressInput&)> onCpu;
  bool technique = false;  ///< out1 is a hit
};

/// Nothing if the subject has no shader text.
std::optional<StressProgram> stressProgram(const stress::StressSubject& subject);

}  // namespace boxprobe
