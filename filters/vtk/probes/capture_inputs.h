// The picture's contents as captures depend on them: objects as they are placed now, with fingerprints that are worked
// out once for a set of models and an image of the sky. Called by the probe set; hands values to the plan, which knows
// no VTK.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/probes/capture_key.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class CaptureInputs {
 public:
  /// What captures of `content` show now; `probes` of its scene.
  CaptureWorld world(const SceneContent& content, const ProbeIndex& probes);

 private:
  std::string hidingKey(const SceneContent& content);

  std::vector<std::string> contentKeys_;  ///< of the objects
  int contentGeneration_ = -1;
  std::vector<std::weak_ptr<const Model>> hidingModels_;
  std::string hidingKey_;  ///< of those: what can hide a lamp
  std::weak_ptr<const ImageRgbaF> skyImage_;
  std::string skyPixels_;
};

}  // namespace boxprobe
