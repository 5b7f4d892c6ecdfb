// The ray-traced scene, against which techniques are measured: what the camera sees, and what every reflecting surface
// reflects, one bounce over its lobe. Exact definition:
//
// - Surfaces are lit as in a probe's first capture (CaptureLight): emission, the scene's lights (without
//   shadows, except for lights that request them, whose shadows are traced; see shadow_light.h), and the sky's diffuse
//   light, also indoors, except where a probe is open to the sky. The picture of a technique has its probes' diffuse
//   light instead, so errors have to be measured on metals, on the reflection alone, or with that light given
//   (ReferenceSettings).
// - Reflections sample GGX's visible normals and evaluate distribution, height-correlated masking and Fresnel's term
//   per ray, without tables or mean weights. The hit of a reflection ray looks as in the first capture: a mirror in a
//   mirror is black.
// - Reflection rays see what probes see or, on request, what the picture shows. What probes see is lit as seen from the
//   capture origin of the probe with the largest share at the ray's start, because no projection can move a highlight
//   with the eye. On request it is lit as seen along the ray.
// - Translucent surfaces count as opaque; textures have no mip levels.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "filters/reference/light/bright_sky.h"
#include "filters/reference/light/capture_light.h"
#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/trace/lamp_triangles.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

struct ReferenceSettings {
  int width = 1280;
  int height = 720;
  int samplesPerPixel = 4;  ///< 1, 4 or 16 positions in a pixel, those of SceneRenderer::renderLinear
  int raysPerPixel = 256;   ///< over all positions; see planRays
  bool full = false;        ///< reflection rays see what the picture shows
  std::uint64_t seed = 1;
  /// Diffuse light of what the camera sees, as in the probes' picture, so that only the reflection differs from it.
  /// Null: the sky's alone.
  std::shared_ptr<const ProbesDiffuse> diffuse;
  PicturePart part;  ///< the rectangle to compute; the rest stays black
};

class ReferenceScene {
 public:
  /// `skyImage`: the sky's picture if it has one. Throws WorkError.
  ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                 std::shared_ptr<const ImageRgbaF> skyImage);
  /// For a scene that differs from that of `sameLight` in surfaces only: shares sky, lights and probes, which take
  /// seconds to prepare.
  ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                 const ReferenceScene& sameLight);

  const SceneTracer& tracer() const { return tracer_; }
  const CaptureLight& light() const { return *light_; }

  /// Radiance that arrives along a ray, as reflections see it. RaySees::Probes: as captured.
  glm::dvec3 seenFrom(const glm::dvec3& originWorld, const glm::dvec3& directionWorld, RaySees sees) const;

  /// One estimate of the colour of a surface point lit by its surroundings. `away`: the start of reflection rays.
  glm::dvec3 reflectedFrom(const SurfacePoint& surface, const glm::dvec3& away, RaySees sees, int rays,
                           std::uint64_t seed) const;

  ReferencePicture render(const Camera& camera, const ReferenceSettings& settings,
                          const ReferenceProgress& progress = {}) const;

 private:
  glm::dvec3 sent(const TracedHit& hit, const glm::dvec3& originWorld, RaySees sees) const;
  glm::dvec3 reflected(const ReflectingLayer& layer, const glm::dvec3& view, const glm::dvec3& away, RaySees sees,
                       int rays, std::uint64_t seed) const;
  glm::dvec3 sheenReflected(const SurfacePoint& surface, const glm::dvec3& away, RaySees sees, int rays,
                            std::uint64_t seed) const;
  std::vector<glm::vec3> throughTo(const TracedHit& hit, RaySees sees, int side) const;

  SceneTracer tracer_;
  LampTriangles lamps_;
  std::shared_ptr<const CaptureLight> light_;
  std::shared_ptr<const BrightSky> brightSky_;
};

/// Positions along each side of a pixel for 1, 4 or 16 in all.
int positionsPerSide(int samplesPerPixel);

}  // namespace boxprobe
