// A depth map of some of a scene's objects as a light sees them, and the program that draws it. Every function needs
// the window's context current. Called by the shadows of what moves and of suns.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <memory>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/frame/depth_geometry.h"
#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/scene/scene_content.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

struct ShadowMap {
  GLuint texture = 0;
  int size = 0;  ///< texels a side
  Framebuffer framebuffer;
};

/// Any direction that is not nearly along `forward` (unit).
glm::dvec3 anyUp(const glm::dvec3& forward);

class ShadowMapPainter {
 public:
  ShadowMapPainter(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content)
      : window_(window), state_(std::move(state)), content_(content) {}

  /// Of the objects that `casts` says so of, into a map of `size` texels a side; `mapFromWorld`: world to [0, 1]³.
  /// Throws WorkError.
  void draw(ShadowMap& map, int size, const glm::dmat4& mapFromWorld,
            const std::function<bool(const DrawnObject&)>& casts);
  static void release(ShadowMap& map);
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  DepthGeometry geometry_;
  vtkShaderProgram* program_ = nullptr;
};

}  // namespace boxprobe
