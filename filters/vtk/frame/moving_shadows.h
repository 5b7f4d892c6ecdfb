// Shadow maps of what moves: a depth map for each light whose shadows want one, of the objects that baked probes leave
// out, drawn when one of them or the light has moved. Where nothing moves, or no such light shines, there is no map.
// The map lies tightly about what moves: beyond its edges there is no shadow, and what lies behind it is in it.
#pragma once

#include <deque>
#include <memory>

#include "filters/vtk/frame/shadow_map.h"

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
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  bool stale_ = true;
  ShadowMapPainter painter_;
  std::deque<ShadowMap> maps_;
};

}  // namespace boxprobe
