// Draws a planar mirror's picture of moving objects. First all static objects that may hide them, as depth only with an
// empty fragment program: so a pillar between mirror and figure hides it exactly, at any distance, which a comparison
// with a probe's distances (one origin, limited resolution) could not; it costs a fraction of the figure. Then the
// objects themselves, lit as in the picture by separate programs, so that the picture's programs stay unchanged.
#pragma once

#include <vtkSmartPointer.h>

#include <map>
#include <memory>
#include <vector>

#include "filters/core/geometry/mirror_view.h"
#include "filters/vtk/frame/mirror_target.h"
#include "filters/vtk/scene/scene_content.h"

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkTargetPass;

namespace boxprobe {

class MirrorPainter {
 public:
  MirrorPainter(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content);
  ~MirrorPainter();

  /// `moving` and `hiding`: indices of the content's objects. `view`: the mirrored one; `heightPlane` (world, for
  /// positions relative to its eye) gives heights relative to the maximum.
  void paint(const PictureView& view, const glm::dvec4& heightPlane, const std::vector<std::size_t>& moving,
             const std::vector<std::size_t>& hiding, MirrorTarget& target);

  /// The view as a VTK camera; valid until the next call.
  vtkCamera* camera(const PictureView& view);
  /// To be called when the objects were replaced.
  void forgetObjects() { twins_.clear(); }
  void release();

 private:
  vtkProp* twinOf(std::size_t object, bool depthOnly);

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkTargetPass> pass_;
  vtkSmartPointer<vtkCamera> camera_;
  std::map<std::pair<std::size_t, bool>, vtkSmartPointer<vtkActor>> twins_;  ///< by object; true: depth only
};

}  // namespace boxprobe
