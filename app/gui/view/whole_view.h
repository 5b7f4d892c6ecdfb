// While it lives the renderer shows the whole scene, whatever the window hides, outlines or cuts away.
#pragma once

#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

class WholeView {
 public:
  explicit WholeView(SceneRenderer& renderer) : renderer_(renderer), view_(renderer.windowView()) {
    renderer_.setWindowView({});
  }
  ~WholeView() { renderer_.setWindowView(view_); }
  WholeView(const WholeView&) = delete;
  WholeView& operator=(const WholeView&) = delete;

 private:
  SceneRenderer& renderer_;
  WindowView view_;
};

}  // namespace boxprobe
