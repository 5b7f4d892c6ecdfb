// Refines a picture at rest in stages of 64, 256 rays per pixel and more, or from 256 on; each averages frames whose
// rays are blurred for the number of the stage. A stage is blended with the previous one as its rays come in, and has
// replaced it at its end. So the result does not depend on how it was reached, nothing jumps, and the difference of two
// stages estimates the remaining error.
#pragma once

#include <vector>

#include "filters/vtk/draw/refined_rays.h"

namespace boxprobe {

struct RefineSettings {
  int rays = 0;          ///< per pixel, in the last stage; 0: no refinement
  double until = 0.0;    ///< stop at this estimated relative error; 0: only `rays` ends it
  double seconds = 0.0;  ///< stop after the frame that ends later than this after the first; 0: no limit
  bool operator==(const RefineSettings& o) const { return rays == o.rays && until == o.until && seconds == o.seconds; }

  static constexpr int kRays = 256;
  static constexpr int kMostRays = 16384;
};

/// The progress of a refined picture.
struct RefineState {
  int rays = 0;        ///< of the last complete stage
  bool more = false;   ///< further rays will follow
  double left = -1.0;  ///< estimated remaining relative error, of what rays can change; negative: unknown
};

/// The difference of two pictures, over the pixels that differ.
struct PictureChange {
  double relativeRms = 0.0;   ///< root of the sum of squared differences over that of the squares
  double stepsOf8Bits = 0.0;  ///< 99.9 % quantile over pixels, in display colours
  bool operator==(const PictureChange& o) const {
    return relativeRms == o.relativeRms && stepsOf8Bits == o.stepsOf8Bits;
  }
};

class Refinement {
 public:
  /// Starts. `firstGuess`: the number of rays that the technique's own frame is worth.
  void begin(const RefineSettings& settings, int firstGuess);
  /// To be called when the current stage has all its frames. Advances to the next, or ends. `within`: the difference
  /// between its first frames, framesOfPart(), and all of them; none: unknown.
  void endStage(const PictureChange& change, const PictureChange& within = {});
  /// Are there frames to draw after the technique's own?
  bool more() const { return stage_ < stages_.size(); }

  const RefineSettings& settings() const { return settings_; }
  /// Of the current stage.
  RefinedRays rays() const;
  int frames() const;
  /// A quarter of frames(), whose rays have about twice the noise of all.
  int framesOfPart() const { return (frames() + 3) / 4; }
  /// The weight of its average in the picture after `framesDone` frames.
  double share(int framesDone) const;

  /// Frames in total; below, those of the complete stages.
  int framesInAll() const;
  int framesBefore() const;
  int raysDone() const { return stage_ == 0 ? 0 : stages_[stage_ - 1]; }
  /// The relative error remaining after the last complete stage, of what rays can change; negative: unknown.
  double left() const { return left_; }
  /// Smaller changes are invisible.
  static constexpr double kNothingShows = 0.5;

 private:
  std::vector<int> stages_;
  std::size_t stage_ = 0;
  RefineSettings settings_;
  double left_ = -1.0;
};

/// `before` and `after`: RGBA, linear.
PictureChange pictureChange(const std::vector<float>& before, const std::vector<float>& after, double exposure);

}  // namespace boxprobe
