// What a surface sends out as a probe's first capture shows it: its own emission, the light sources, the sky's diffuse
// light, and the sky's reflection where no probe reaches (where one does it is still black). Called for what reflection
// rays hit, and, without the reflection, for what the camera sees. Knows no ray.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "filters/core/geometry/probe_diffuse.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/scene.h"
#include "filters/core/surface/direct_light.h"
#include "filters/core/surface/surface_point.h"
#include "filters/reference/light/reference_sky.h"
#include "filters/reference/light/reflecting_layers.h"

namespace boxprobe {

class CaptureLight {
 public:
  /// `skyImage`: the picture of the sky if it is one.
  CaptureLight(const Scene& scene, std::shared_ptr<const ImageRgbaF> skyImage);

  const ReferenceSky& sky() const { return sky_; }
  Energy energy() const { return energy_; }

  const std::vector<Light>& lights() const { return lights_; }
  /// Emission, light sources and diffuse light. `through`: how much of each light arrives, null for all of it.
  /// `diffuse`: of probes, lamps and sky as a picture has it, and of light sources what is seen; null: the sky's alone,
  /// as a first capture has it.
  glm::vec3 unreflected(const SurfacePoint& surface, bool unlit, const std::vector<glm::vec3>* through = nullptr,
                        const ProbesDiffuse* diffuse = nullptr) const;
  /// That and the sky's reflection: what a capture shows.
  glm::vec3 captured(const SurfacePoint& surface, bool unlit, const std::vector<glm::vec3>* through = nullptr) const;

  /// Where the probe was captured that has the largest share of a point's reflection; nothing where none reaches.
  std::optional<glm::dvec3> capturedFrom(const glm::dvec3& positionWorld) const;

 private:
  /// Shares of a point's diffuse light and reflection, as probes and sky divide it.
  struct Shares {
    float diffuse = 1.0f;  ///< of the sky's irradiance: probes give it times their intensity
    float sky = 1.0f;      ///< what the probes leave
  };
  Shares shares(const glm::dvec3& positionWorld) const;
  glm::vec3 irradiance(const SurfacePoint& surface, const ProbesDiffuse& diffuse) const;
  /// `through` times what the picture has of each light source there.
  std::vector<glm::vec3> seenThrough(const SurfacePoint& surface, const ProbesDiffuse& diffuse,
                                     const std::vector<glm::vec3>* through) const;
  Scattering scattering(const SurfacePoint& surface, const FresnelEnds& ends) const;

  ReferenceSky sky_;
  Energy energy_;
  std::vector<Light> lights_;
  struct LightingProbe : ProbeGeometry {
    bool open = false;      ///< its captures go without the sky's light
    std::size_t index = 0;  ///< in the scene
  };
  std::vector<LightingProbe> probes_;  ///< most important first
};

}  // namespace boxprobe
