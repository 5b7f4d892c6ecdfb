// The view through glass, in every form, for all normals, views and indices: results must be finite, directions unit,
// shares in [0, 1]. Other tests check the values against geometry.
#include "filters/stress/subject_glass.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/shared/refraction.h"
#include "filters/stress/stress_subjects.h"

namespace boxprobe::stress {

namespace {

/// A sphere as large as the input's box, seen from its centre.
struct BallShell : shading::ShellSampler {
  float radius = 1.0f;
  glm::vec4 fetchShell(const glm::vec3& direction) const override {
    const float length = glm::length(direction);
    return length > 0.0f && std::isfinite(length) ? glm::vec4(direction / length, radius) : glm::vec4(0, 0, 1, radius);
  }
};

bool share(float x) {
  return x >= 0.0f && x <= 1.0f;
}

}  // namespace

Trial tryGlass(const StressInput& input, const StressClass&, TrialLog* log) {
  const LocalInput in = localInput(input);
  BallShell ball;
  const auto size = static_cast<float>(std::min(boxSize(in.probe, in.point.position), 1.0e15));
  ball.radius = 0.5f * size;
  // From total reflection to the strongest refraction, including 1 and its neighbours.
  const float iors[] = {1.0e-30f, 1.0e-3f, 0.7f, 0.99999994f, 1.0f, 1.0000001f, 1.33f, 1.5f, 2.4f, 1.0e18f};
  shading::GlassObject glass{};
  glass.ior = iors[static_cast<unsigned>(input.pixel.x) % 10u];
  glass.form = 1 + static_cast<int>(static_cast<unsigned>(input.pixel.y) % 3u);
  glass.sheet = input.frame % 5 == 4;
  glass.thickness = input.blendDistance > 0.0f && input.blendDistance < 1.0e15f ? input.blendDistance : 0.0f;
  glass.radius = ball.radius;
  // The surface may lie anywhere: what is drawn and the shell need not agree.
  const glm::vec3 position = glm::length(in.point.position) < 1.0e15f ? in.point.position : glm::vec3(0.0f);
  const bool back = (input.pixel.x & 64) != 0;
  const shading::GlassView seen = shading::lookThroughGlass(&ball, glass, position, in.point.normal, in.point.view,
                                                            in.point.roughness, back, glm::length(position));
  Trial trial;
  for (const shading::GlassRay& ray : {seen.through, seen.mirrored}) {
    const float deviation = shading::glassDeviation(glass, ray, position, in.point.view);
    const glm::vec3 left = shading::glassTransmittance(glm::vec3(0.0f, 0.5f, 1.0f), glass.thickness, ray.distance);
    trial.require(finite(ray.position) && finite(ray.direction) && std::isfinite(ray.distance) &&
                      std::isfinite(deviation) && finite(left),
                  share(ray.alpha) && share(left.x) && share(left.y) && share(left.z) && ray.distance >= 0.0f);
  }
  trial.require(std::isfinite(seen.reflectance), share(seen.reflectance));
  if (log != nullptr) {
    log->add("index", static_cast<double>(glass.ior));
    log->add("T", seen.through.direction);
    log->add("reflectance", static_cast<double>(seen.reflectance));
  }
  return trial;
}

}  // namespace boxprobe::stress
