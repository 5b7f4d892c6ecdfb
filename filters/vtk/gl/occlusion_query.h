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
  /// Pixels of the framebuffer from the lower left corner.
  struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
  };
  /// Where the farthest depth there is, that of a cleared buffer, shows past what has been drawn so far: a rectangle
  /// around all such places, of whole tiles of a grid; empty if there are none.
  Rectangle farthestShows(vtkRenderer* renderer);
  void release();

 private:
  void haveQueries(std::size_t count);

  vtkShaderProgram* program_ = nullptr;
  FullScreenPass farthest_;
  GLuint vertexArray_ = 0;
  std::vector<GLuint> queries_;
};

}  // namespace boxprobe
