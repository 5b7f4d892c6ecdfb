// What rays of the window meet in the scene on show: for snapping, drop lines, picking and the camera. The structure is
// built when it is first asked for, and again after the geometry changed. Called by the main window.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "filters/core/scene/document.h"
#include "filters/fit/rays/triangle_rays.h"
#include "filters/vtk/draw/window_view.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

/// What is under the pointer.
struct PickedObject {
  std::string node;      ///< glTF node name; may be empty
  std::string material;  ///< empty: the default material
};

/// What rays of the pointer pass: see WindowView. Locked objects are seen, and not picked.
struct PassedParts {
  std::set<std::string> hidden, locked;
  std::optional<CutBox> cutaway;
};

class SceneSurfaces {
 public:
  explicit SceneSurfaces(const Document& document) : document_(document) {}

  void setModels(const TriangleRays::Models& models);
  void documentChanged(const Changes& changes);
  /// Null where there is nothing to meet.
  const SurfaceRays* rays();
  void setView(PassedParts passed);
  /// World; nothing where the ray goes into the sky. Of what the window shows, without glass.
  std::optional<glm::dvec3> meet(const Ray& ray);
  /// Of the first visible surface that is not locked, glass included; nothing where the ray goes into the sky.
  std::optional<PickedObject> objectAt(const Ray& ray) const;

 private:
  struct Traced {
    std::unique_ptr<TriangleRays> rays;
    bool failed = false;  ///< the ray tracer could not take it: not tried again before something changes
  };
  const SurfaceRays* traced(Traced& of, const std::set<std::string>& hidden) const;
  void forget();
  Ray behindCut(const Ray& ray) const;

  PassedParts passed_;
  const Document& document_;
  TriangleRays::Models models_;
  Traced whole_;
  Traced shown_;  ///< without what is hidden
};

}  // namespace boxprobe
