// The true scene, ray traced: what the camera sees, and what every reflecting surface reflects, one bounce over its
// lobe. What techniques are measured against. Called by the command line, the benchmark and tests; knows no GL.
//
// What it is, exactly:
// - Surfaces are lit as by a probe's first capture (CaptureLight): emission, the scene's lights - without shadows, but
//   for those that ask for them, which have a traced area light's (shadow_light.h) - the sky's diffuse light even
//   indoors, though not where a probe is open to the sky. A technique's picture has its probes' diffuse light there, so
//   errors are to be measured on metals, or on the reflection alone; or that light is given (ReferenceSettings).
// - Reflections: GGX over visible normals, distribution, height-correlated masking and Fresnel's term evaluated for
// each
//   ray; no table and no mean weight stands between. What a reflection ray hits shows what the first capture shows: a
//   mirror in a mirror is black.
// - Reflection rays see what the probes see, or, on request, what the picture shows. What the probes see
//   is lit as looked at from the capture origin of the probe that counts most where the ray starts: a highlight that
//   moves with the eye is nothing that a projection could bring back. On request it is looked at along the ray.
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
  /// Of what the camera sees: diffuse light as the probes' picture has it, so that nothing but the reflection differs
  /// from it. Null: the sky's alone.
  std::shared_ptr<const ProbesDiffuse> diffuse;
  PicturePart part;  ///< what of the picture is wanted; the rest stays black
};

class ReferenceScene {
 public:
  /// `skyImage`: the sky's picture if it has one. Throws WorkError.
  ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                 std::shared_ptr<const ImageRgbaF> skyImage);
  /// Of a scene that differs from that of `sameLight` in surfaces alone: sky, lights and probes are shared, which take
  /// seconds to prepare.
  ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                 const ReferenceScene& sameLight);

  const SceneTracer& tracer() const { return tracer_; }
  const CaptureLight& light() const { return *light_; }

  /// Radiance that arrives along a ray, as reflections see it. RaySees::Probes: as captured.
  glm::dvec3 seenFrom(const glm::dvec3& originWorld, const glm::dvec3& directionWorld, RaySees sees) const;

  /// Lit by its surroundings: one estimate of a surface point's colour. `away` is where reflection rays start.
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
