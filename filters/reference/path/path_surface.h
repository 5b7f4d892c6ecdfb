// What a path meets: a scene's triangles through Embree, and the material at a point as glTF defines it. Written from
// the specification, not from the renderer.
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

/// The largest component, at least 0.
inline double largestOf(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z, 0.0});
}

/// The intersection of a ray with a triangle.
struct PathHit {
  int object = 0;  ///< index into TriangleScene::objects
  std::uint32_t triangle = 0;
  glm::dvec2 barycentric{0.0};  ///< weights of the second and third corner
  double distance = 0.0;        ///< along the unit ray, scene units
  glm::dvec3 position{0.0};     ///< relative to the scene's anchor
  glm::dvec3 normal{0.0};       ///< of the triangle, unit, on the side of the ray
  bool back = false;            ///< the ray met the back face
};

/// The material at a point. Colours linear; directions in the scene's axes.
struct PathSurface {
  glm::dvec3 normal{0.0};  ///< shading normal, on the side that was met
  glm::dvec3 coatNormal{0.0};
  glm::dvec3 tangent{0.0};  ///< unit, in the plane of the shading normal; the microfacets' slopes vary least along it
  glm::dvec3 color{0.0};
  double opacity = 1.0;
  double metallic = 0.0, roughness = 1.0;
  double f0 = 0.04;  ///< of the non-metal, before tinting
  glm::dvec3 specularTint{1.0};
  double specularEdge = 1.0;  ///< reflectance of the non-metal at grazing angles
  glm::dvec3 emission{0.0};
  double coat = 0.0, coatRoughness = 0.0;
  glm::dvec3 sheen{0.0};
  double sheenRoughness = 0.0;
  double anisotropy = 0.0;
  const PathFilm *film = nullptr, *metalFilm = nullptr;  ///< owned by the scene; null: none
  double filmShare = 0.0, filmThickness = 0.0;           ///< covered share of the surface; nanometres
  double transmission = 0.0, ior = 1.5;
  bool thin = true;
  bool inside = false;         ///< of a transmitting solid: the ray is inside it
  glm::dvec3 absorption{0.0};  ///< per scene unit, inside that solid
};

class PathScene {
 public:
  /// Throws WorkError if Embree fails.
  explicit PathScene(TriangleScene scene);
  ~PathScene();
  PathScene(const PathScene&) = delete;
  PathScene& operator=(const PathScene&) = delete;

  const TriangleScene& scene() const { return scene_; }

  /// The nearest triangle of what the picture shows. `eye`: for camera rays the back of a single-sided surface does not
  /// exist; for all other rays it does, unless it is emissive. Masked-out texels never exist. `direction` is unit; both
  /// are relative to the anchor.
  std::optional<PathHit> first(const glm::dvec3& origin, const glm::dvec3& direction, bool eye) const;
  /// The transmittance from a hit over `distance`: 0 behind anything opaque, else the product of blended surfaces.
  /// `object`: the source of the light, whose own surface does not block; -1: none.
  double passes(const PathHit& from, const glm::dvec3& direction, double distance, int object) const;

  PathSurface surface(const PathHit& hit, const glm::dvec3& direction) const;
  /// A start for rays on the side of `side` (a direction): single precision may put the point on either side of its
  /// triangle, off by about 1e-7 of its distance from the anchor.
  glm::dvec3 away(const PathHit& hit, const glm::dvec3& side) const;

 private:
  struct Structures;
  TriangleScene scene_;
  struct Films {
    std::shared_ptr<const PathFilm> dielectric, metal;
  };
  static std::vector<Films> filmsOf(const TriangleScene& scene);
  std::vector<Films> films_;  ///< per object; null: none
  std::unique_ptr<Structures> structures_;
};

}  // namespace boxprobe
