// Shader text and C++ of what the stress test compares: one program for a technique or a term. Knows no OpenGL.
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <string>

#include "filters/stress/stress_trial.h"

namespace boxprobe {

/// Two vectors a pixel: of a technique what it looked up and (hit, distance), of a term its value.
struct StressValues {
  glm::vec4 value{0.0f}, hit{0.0f};
};

struct StressProgram {
  std::string declarations;  ///< functions before main()
  std::string body;          ///< reads `probe`, `point` and `extra`, writes `out0` and `out1`
  std::function<StressValues(const stress::StressInput&)> onCpu;
  bool technique = false;  ///< out1 is a hit
};

/// Nothing if a subject has no shader text of its own.
std::optional<StressProgram> stressProgram(const stress::StressSubject& subject);

}  // namespace boxprobe
