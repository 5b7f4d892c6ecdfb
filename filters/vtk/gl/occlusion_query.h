// Asks the depth buffer whether anything in a box could be seen: hardware occlusion queries of the box itself, several
// at once, so that one wait serves them all. Called by the culled renderer while a frame is being drawn.
#pragma once

#include <functional>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/opengl.h"

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

namespace boxprobe {

class OcclusionQuery {
 public:
  OcclusionQuery();
  ~OcclusionQuery();
  OcclusionQuery(const OcclusionQuery&) = delete;
  OcclusionQuery& operator=(const OcclusionQuery&) = delete;

  /// For each box: could something in it be seen past what has been drawn so far? A box about the eye always could.
  std::vector<bool> visible(vtkRenderer* renderer, const std::vector<Box>& boxes);
  /// Does the farthest depth there is, that of a cleared buffer, show past what has been drawn so far?
  bool farthestVisible(vtkRenderer* renderer);
  void release();

 private:
  void haveQueries(std::size_t count);

  vtkShaderProgram* program_ = nullptr;
  FullScreenPass farthest_;
  GLuint vertexArray_ = 0;
  std::vector<GLuint> queries_;
};

}  // namespace boxprobe
