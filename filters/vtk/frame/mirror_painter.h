// Draws what a planar mirror shows of objects that move. First everything that stands still and may hide them, into
// depth alone and by a program that does nothing: a pillar between the mirror and a figure hides it exactly, at any
// distance, which a comparison with a probe's distances (one origin, its own resolution) could not; measured, it costs
// a fraction of the figure. Then the objects themselves, lit as in the picture by programs of their own, so that those
// of the picture stay as they are. Called by the mirror set; decides nothing.
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

  /// `moving` and `hiding`: indices of the content's objects. `view` is the mirrored one; `heightPlane` (world, of
  /// positions relative to its eye) gives heights in parts of the highest.
  void paint(const PictureView& view, const glm::dvec4& heightPlane, const std::vector<std::size_t>& moving,
             const std::vector<std::size_t>& hiding, MirrorTarget& target);

  /// The view as VTK's camera has it; valid until the next call.
  vtkCamera* camera(const PictureView& view);
  /// The objects were replaced.
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
  std::map<std::pair<std::size_t, bool>, vtkSmartPointer<vtkActor>> twins_;  ///< by object; true: depth alone
};

}  // namespace boxprobe
