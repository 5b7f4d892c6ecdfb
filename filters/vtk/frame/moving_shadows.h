// Shadow maps of what moves: a depth map for each light whose shadows want one, of the objects that baked probes leave
// out, drawn when one of them or the light has moved. Where nothing moves, or no such light shines, there is no map.
// The map lies tightly about what moves: beyond its edges there is no shadow, and what lies behind it is in it.
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

/// Of the light's map, world to [0, 1]³. Nothing for a light amid what moves.
std::optional<glm::dmat4> movingMapFromWorld(const Light& light, const Box& casters);

class MovingShadows {
 public:
  MovingShadows(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content);

  void sceneChanged() { stale_ = true; }
  /// Draws what is stale into the state's maps; the window's context is current.
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
