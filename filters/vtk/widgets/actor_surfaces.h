// The surfaces that a renderer's actors show, for rays: what a dragged face snaps to. Needs no OpenGL and no ray
// tracer.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "filters/fit/rays/surface_rays.h"

class vtkMatrix4x4;
class vtkRenderer;
class vtkStaticCellLocator;

namespace boxprobe {

class ActorSurfaces : public SurfaceRays {
 public:
  /// As they are now: visible actors under vtkPolyDataMapper, parts of assemblies as well. Null: nothing is there.
  explicit ActorSurfaces(vtkRenderer* renderer);
  ~ActorSurfaces() override;
  ActorSurfaces(const ActorSurfaces&) = delete;
  ActorSurfaces& operator=(const ActorSurfaces&) = delete;

  /// Distance and normal alone: roughness and reflectance are those of nothing in particular.
  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override;
  const Box& bounds() const override { return bounds_; }

 private:
  struct Surface {
    vtkSmartPointer<vtkStaticCellLocator> locator;
    vtkSmartPointer<vtkMatrix4x4> worldFromModel, modelFromWorld;
  };
  std::vector<Surface> surfaces_;
  Box bounds_{glm::dvec3(0.0), glm::dvec3(0.0)};
};

}  // namespace boxprobe
