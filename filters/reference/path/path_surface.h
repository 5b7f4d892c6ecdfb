// What a path meets: a scene's triangles by Embree, and the material at one of their points as glTF states it. Written
// from the specification, and not from what the renderer compiles.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "filters/reference/path/path_film.h"
#include "filters/reference/trace/triangle_scene.h"

namespace boxprobe {

inline constexpr double kPathPi = 3.14159265358979323846;
inline constexpr double kPathInfinity = std::numeric_limits<double>::infinity();

/// Its largest component, at least 0.
inline double largestOf(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z, 0.0});
}

/// A point of a triangle that a ray has met.
struct PathHit {
  int object = 0;  ///< index into TriangleScene::objects
  std::uint32_t triangle = 0;
  glm::dvec2 barycentric{0.0};  ///< weights of the second and third corner
  double distance = 0.0;        ///< along the unit ray, scene units
  glm::dvec3 position{0.0};     ///< relative to the scene's anchor
  glm::dvec3 normal{0.0};       ///< of the triangle, unit, towards where the ray came from
  bool back = false;            ///< the ray met the triangle's back
};

/// The material at a point. Colours linear; directions in the scene's axes.
struct PathSurface {
  glm::dvec3 normal{0.0};  ///< shading normal, on the side that was met
  glm::dvec3 coatNormal{0.0};
  glm::dvec3 tangent{0.0};  ///< unit, in the plane of the shading normal: along which the microfacets lean least
  glm::dvec3 color{0.0};
  double opacity = 1.0;
  double metallic = 0.0, roughness = 1.0;
  double f0 = 0.04;  ///< of the non-metal, before its tint
  glm::dvec3 specularTint{1.0};
  double specularEdge = 1.0;  ///< what the non-metal reflects at a flat angle
  glm::dvec3 emission{0.0};
  double coat = 0.0, coatRoughness = 0.0;
  glm::dvec3 sheen{0.0};
  double sheenRoughness = 0.0;
  double anisotropy = 0.0;
  const PathFilm *film = nullptr, *metalFilm = nullptr;  ///< of the scene; null: none
  double filmShare = 0.0, filmThickness = 0.0;           ///< of the surface that it covers; nanometres
  double transmission = 0.0, ior = 1.5;
  bool thin = true;
  bool inside = false;         ///< of a solid that transmits light: the ray came through it
  glm::dvec3 absorption{0.0};  ///< per scene unit, within that solid
};

class PathScene {
 public:
  /// Throws WorkError if Embree refuses.
  explicit PathScene(TriangleScene scene);
  ~PathScene();
  PathScene(const PathScene&) = delete;
  PathScene& operator=(const PathScene&) = delete;

  const TriangleScene& scene() const { return scene_; }

  /// The nearest triangle of what the picture shows. `eye`: the ray is the camera's, to which the back of a
  /// single-sided surface is not there; to every other ray it is, unless it shines. What a material masks out is never
  /// there. `direction` is unit; both relative to the anchor.
  std::optional<PathHit> first(const glm::dvec3& origin, const glm::dvec3& direction, bool eye) const;
  /// Share of light that passes from a hit to what lies `distance` from it: 0 behind anything opaque, else what blended
  /// surfaces leave.
  /// `object`: the one that the light comes from, whose own surface is not in the way; -1: none.
  double passes(const PathHit& from, const glm::dvec3& direction, double distance, int object) const;

  PathSurface surface(const PathHit& hit, const glm::dvec3& direction) const;
  /// A start for rays on the side of `side` (a direction): single precision puts the point on either side of its
  /// triangle, by some ten-millionths of how far it lies from the anchor.
  glm::dvec3 away(const PathHit& hit, const glm::dvec3& side) const;

 private:
  struct Structures;
  TriangleScene scene_;
  struct Films {
    std::shared_ptr<const PathFilm> dielectric, metal;
  };
  static std::vector<Films> filmsOf(const TriangleScene& scene);
  std::vector<Films> films_;  ///< by object; null: none
  std::unique_ptr<Structures> structures_;
};

}  // namespace boxprobe
