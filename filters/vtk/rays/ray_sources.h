// Start points of projection rays on a scene's surfaces: under the pointer, over an object, along a line, on a grid of
// pixels. Geometry only: interpolated normals without normal maps, roughness with its texture. Expensive data are
// computed once per scene, when first needed.
#pragma once

#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/rays/ray_glass.h"
#include "filters/vtk/rays/ray_pixels.h"

class vtkPolyData;

namespace boxprobe {

class RayScene;

/// A point on a surface.
struct RaySample {
  std::string object;  ///< node name
  glm::dvec3 positionWorld{0.0};
  glm::dvec3 normalWorld{0.0};  ///< unit; on the side it was seen from
  float roughness = 0.0f;       ///< perceptual
  int glass = -1;               ///< index into RaySources::glass(); -1: opaque
  bool back = false;            ///< its inner side is seen
};

/// The filter's input: double points with "Normals", "roughness" and "glass" (2 x index, + 1 from inside; -1: none).
vtkSmartPointer<vtkPolyData> rayPoints(const std::vector<RaySample>& samples);

class RaySources {
 public:
  /// `models` in the order of scene.models; keeps what it needs of both. Make a new one when models, placements,
  /// materials or visibility have changed.
  RaySources(std::vector<std::shared_ptr<const Model>> models, const Scene& scene);
  ~RaySources();
  RaySources(const RaySources&) = delete;
  RaySources& operator=(const RaySources&) = delete;

  /// The visible objects that transmit light, for the filter; below, the index of one by its name, -1 if it is opaque.
  const std::vector<RayGlass>& glass() const { return glass_; }
  int glassOf(const std::string& object) const;

  /// Names of the visible objects, in the models' order.
  std::vector<std::string> objects() const;
  /// The visible scene in world space, for the filter's true hit.
  vtkPolyData* triangles();

  /// The first visible surface along a ray: passes through back faces that are not drawn.
  std::optional<RaySample> under(const PixelRay& ray);
  /// Uniform in area over all triangles of an object; deterministic. Empty for an unknown name.
  std::vector<RaySample> over(const std::string& object, int count);
  /// Points of a segment, dropped along `drop` onto the surface below; omits those with nothing below.
  std::vector<RaySample> alongLine(const glm::dvec3& fromWorld, const glm::dvec3& toWorld, int count,
                                   const glm::dvec3& drop = {0.0, -1.0, 0.0});
  /// Under the centres of columns x rows equal parts of the picture.
  std::vector<RaySample> screenGrid(const PixelRays& rays, int columns, int rows);

 private:
  struct Part;  // an instance as it is drawn
  struct Triangle;
  void build();
  Triangle triangle(long long cell) const;
  RaySample sample(const Triangle& t, const glm::dvec3& barycentric, const glm::dvec3& seenAlong) const;

  std::vector<std::shared_ptr<const Model>> models_;  // keep the parts' meshes alive
  std::vector<Part> parts_;
  std::vector<RayGlass> glass_;
  vtkSmartPointer<vtkPolyData> triangles_;
  std::vector<int> partOfCell_;
  std::unique_ptr<RayScene> scene_;
};

}  // namespace boxprobe
