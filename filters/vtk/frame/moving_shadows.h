// Shadow maps of moving objects: a depth map per light that requests one, of the objects that baked probes leave out,
// redrawn when one of them or the light has moved. There is no map without moving objects or such lights. The map
// encloses the moving objects tightly: outside its edges there is no shadow, and everything behind them is in shadow.
#pragma once

#include <deque>
#include <memory>

#include "filters/vtk/frame/shadow_map.h"

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
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  bool stale_ = true;
  ShadowMapPainter painter_;
  std::deque<ShadowMap> maps_;
};

}  // namespace boxprobe
