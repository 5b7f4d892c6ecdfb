// One scene of the truth pictures as the program has it: its references and techniques at the truth pictures' size.
// Called by `bench --truth` and by tests.
#pragma once

#include <memory>

#include "app/session/load_scene.h"
#include "filters/reference/study/bench_technique.h"
#include "filters/reference/truth/truth_comparison.h"
#include "filters/reference/truth/truth_trace.h"

namespace boxprobe {

class OffscreenScene;

/// Texels along a face of the captures that reference-box integrates.
inline constexpr int kBoxFaceSize = 512;

class TruthStage {
 public:
  struct Stopped {};

  /// `index` and `shown` must outlive this. `progress` is asked whether to go on; once it said no, rows throw Stopped.
  /// `assignments`: as loadScene() takes them, of how the scene is drawn, not of what is in it. Throws as loadScene()
  /// does.
  TruthStage(const TruthIndex& index, const std::string& scene, OffscreenScene& shown, ReferenceProgress progress = {},
             const std::vector<std::string>& assignments = {});

  /// Of the picture and of all those after it.
  void setFloor(const TruthPicture& picture);

  /// Of the floor that was set.
  TruthRow sceneRow(const TruthPicture& picture, const TruthEffort& effort) const;
  /// Of a scene that is its box alone; at first captured with faces of kBoxFaceSize: what is judged is the integral.
  TruthRow boxRow(const TruthPicture& picture, const TruthEffort& effort);
  /// Captured as the scene has it.
  TruthRow techniqueRow(const TruthPicture& picture, const BenchTechnique& technique);
  /// The same refined at rest by `rays` a pixel, and what is estimated to be left after them; four samples a pixel of
  /// the truth, of a mirror 100. Of 0 rays: the technique's own frame, as fine.
  TruthRow refinedRow(const TruthPicture& picture, const BenchTechnique& technique, int rays, double* left = nullptr);

  const ReferenceScene& reference() const { return *reference_; }
  /// Throws InputError if the scene has none of that name.
  const Camera& camera(const std::string& name) const;

 private:
  void captureShown();
  ReferenceBoxMaps captured(int faceSize);

  const TruthIndex& index_;
  LoadedScene loaded_;
  std::shared_ptr<const ImageRgbaF> sky_;
  OffscreenScene& shown_;
  ReferenceProgress progress_;
  Scene scene_;
  std::vector<std::shared_ptr<const Model>> models_;
  std::unique_ptr<ReferenceScene> reference_;
  ReferenceBoxMaps maps_, coarseMaps_;  ///< by faces of kBoxFaceSize and of half of it
};

}  // namespace boxprobe
