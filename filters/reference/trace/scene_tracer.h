// Traces rays against a scene's triangles with Embree: the first hit, and the surface there. Thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "filters/core/surface/surface_point.h"
#include "filters/reference/trace/triangle_scene.h"

namespace boxprobe {

/// Which objects a ray meets.
enum class RaySees { Picture, Probes };

struct TracedHit {
  int object = 0;  ///< index into TriangleScene::objects
  std::uint32_t triangle = 0;
  glm::dvec2 barycentric{0.0};  ///< weights of the second and third corner
  double distance = 0.0;        ///< scene units
  double cosine = 0.0;          ///< between the ray and the triangle's normal, at least 0
  glm::dvec3 positionWorld{0.0};
  glm::dvec3 frontWorld{0.0};  ///< unit normal of the triangle, on the side that was hit
  bool backSide = false;       ///< of a double-sided object
};

class SceneTracer {
 public:
  /// Throws WorkError if Embree fails (out of memory).
  explicit SceneTracer(TriangleScene scene);
  ~SceneTracer();
  SceneTracer(const SceneTracer&) = delete;
  SceneTracer& operator=(const SceneTracer&) = delete;

  const TriangleScene& scene() const { return scene_; }

  /// The nearest front face (either side of a double-sided object) at a distance above 0; nothing for a zero direction.
  /// `directionWorld` need not be unit. To start from a surface use awayFrom(): single precision may put a point of a
  /// triangle on either side of it.
  std::optional<TracedHit> firstHit(const glm::dvec3& originWorld, const glm::dvec3& directionWorld,
                                    RaySees sees = RaySees::Picture) const;

  /// A start for rays from a hit: off the surface by a few millionths of the scene's radius, on the side that was hit.
  /// A ray into the surface, as normal maps produce, meets the surface itself, like a lookup in a probe's box.
  glm::dvec3 awayFrom(const TracedHit& hit) const;

  /// The surface as the shader computes it there: textures, normal map, overrides; without names.
  SurfacePoint surface(const TracedHit& hit, const glm::dvec3& eyeWorld) const;
  const TracedObject& object(const TracedHit& hit) const {
    return scene_.objects[static_cast<std::size_t>(hit.object)];
  }

 private:
  struct Structures;
  TriangleScene scene_;
  std::unique_ptr<Structures> structures_;
};

}  // namespace boxprobe
