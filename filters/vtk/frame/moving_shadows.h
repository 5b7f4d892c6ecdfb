// Shadow maps of moving objects: a depth map per light that requests one, of the objects that baked probes leave out,
// redrawn when one of them or the light has moved. There is no map without moving objects or such lights. The map
// encloses the moving objects tightly: outside its edges there is no shadow, and everything behind them is in shadow.
#pragma once

#include <deque>
#include <memory>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/frame/depth_geometry.h"
#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/scene/scene_content.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

/// Transform from the world to the light's map, [0, 1]³. Nothing for a light among the moving objects.
std::optional<glm::dmat4> movingMapFromWorld(const Light& light, const Box& casters);

class MovingShadows {
 public:
  MovingShadows(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content);

  void sceneChanged() { stale_ = true; }
  /// Draws outdated maps of the state; needs the window's context current.
  void update();
  void release();

 private:
  struct Map {
    GLuint texture = 0;
    Framebuffer framebuffer;
  };
  void drawMap(Map& map, const glm::dmat4& mapFromWorld);

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  bool stale_ = true;
  DepthGeometry geometry_;
  vtkShaderProgram* program_ = nullptr;
  std::deque<Map> maps_;
};

}  // namespace boxprobe
