// The radiance of a surface in a probe's first capture: emission, light sources, the sky's diffuse light, and the sky's
// reflection where no probe reaches (probes are still black). Used for what reflection rays hit and, without the
// reflection, for what the camera sees.
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
  /// `skyImage`: the picture of the sky if it has one.
  CaptureLight(const Scene& scene, std::shared_ptr<const ImageRgbaF> skyImage);

  const ReferenceSky& sky() const { return sky_; }
  Energy energy() const { return energy_; }

  const std::vector<Light>& lights() const { return lights_; }
  /// Emission, light sources and diffuse light. `through`: transmittance for each light, null for 1. `diffuse`: diffuse
  /// light of probes, lamps and sky as in a picture, and the visibility of light sources; null: the sky's alone, as in
  /// a first capture.
  glm::vec3 unreflected(const SurfacePoint& surface, bool unlit, const std::vector<glm::vec3>* through = nullptr,
                        const ProbesDiffuse* diffuse = nullptr) const;
  /// The above and the sky's reflection: what a capture shows.
  glm::vec3 captured(const SurfacePoint& surface, bool unlit, const std::vector<glm::vec3>* through = nullptr) const;

  /// The capture origin of the probe with the largest share at a point; nothing where no probe reaches.
  std::optional<glm::dvec3> capturedFrom(const glm::dvec3& positionWorld) const;

 private:
  /// How probes and sky share a point's diffuse light and reflection.
  struct Shares {
    float diffuse = 1.0f;  ///< of the sky's irradiance: probes pass it on times their intensity
    float sky = 1.0f;      ///< left by the probes
  };
  Shares shares(const glm::dvec3& positionWorld) const;
  glm::vec3 irradiance(const SurfacePoint& surface, const ProbesDiffuse& diffuse) const;
  /// `through` times the visibility of each light source in the picture.
  std::vector<glm::vec3> seenThrough(const SurfacePoint& surface, const ProbesDiffuse& diffuse,
                                     const std::vector<glm::vec3>* through) const;
  Scattering scattering(const SurfacePoint& surface, const FresnelEnds& ends) const;

  ReferenceSky sky_;
  Energy energy_;
  std::vector<Light> lights_;
  struct LightingProbe : ProbeGeometry {
    bool open = false;      ///< its captures exclude the sky's light
    std::size_t index = 0;  ///< in the scene
  };
  std::vector<LightingProbe> probes_;  ///< in order of decreasing importance
};

}  // namespace boxprobe
