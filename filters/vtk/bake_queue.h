// Captures and filters probes step by step: a face, a level at a time, bounce by bounce. Knows no scene: it is handed
// what to photograph and whom to tell. Called by the scene renderer outside of the window's renders.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/cube_capture.h"
#include "filters/vtk/prefilter.h"

namespace boxprobe {

struct Times;

/// One cubemap to make.
struct BakeItem {
  CaptureSettings settings;
  int faceSize = 256;
  int bounces = 1;
  bool sky = false;  ///< the sky's own map: at infinity, so without distances
  std::vector<vtkProp*> props;
  /// Called at the end of each bounce with the finished maps; later bounces then see them.
  std::function<void(std::shared_ptr<const ProbeMaps>)> publish;
};

class BakeQueue {
 public:
  BakeQueue(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture, Times* times);

  /// Replaces what is under way. At the first bounce no probe has been captured yet: a mirror in a probe is black, and
  /// what is not a mirror gets the diffuse light of the sky in place of the probe's. With `seeCurrentProbes` captures
  /// see the probes as they are, which suits one that follows a drag.
  void start(std::vector<BakeItem> items, std::vector<vtkLight*> lights, bool seeCurrentProbes);
  void abort();
  bool pending() const { return bounce_ > 0; }
  /// One face, one level, or the end of a bounce.
  void step();
  /// Share of the units done, 0..1.
  double progress() const;
  void release();

 private:
  struct Pending {
    std::size_t item;
    std::shared_ptr<ProbeMaps> maps;
  };
  bool advanceItem();
  void endBounce();

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  CubeCapture* capture_;
  Times* times_;
  Prefilter prefilter_;
  CubeTexture source_;

  std::vector<BakeItem> items_;
  std::vector<vtkLight*> lights_;
  bool seeCurrentProbes_ = false;
  int bounce_ = 0;  ///< 0: idle
  int lastBounce_ = 0;
  std::size_t item_ = 0;
  int unit_ = 0;  ///< within an item: 0..5 faces, 6 mip chain and copy, then one a level, then irradiance
  std::shared_ptr<ProbeMaps> maps_;
  std::vector<Pending> finished_;
  double unitsDone_ = 0.0, unitsTotal_ = 1.0;
};

}  // namespace boxprobe
