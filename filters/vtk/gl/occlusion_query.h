// Tests boxes against the depth buffer with hardware occlusion queries, several at once, so that there is one wait for
// all of them.
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

  /// Could something in each box be visible, given the depth drawn so far? Always true for a box around the eye.
  std::vector<bool> visible(vtkRenderer* renderer, const std::vector<Box>& boxes);
  /// Pixels of the framebuffer from the lower left corner.
  struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
  };
  /// A rectangle around all pixels with the depth of a cleared buffer, rounded out to tiles of a grid; empty if there
  /// are none.
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
