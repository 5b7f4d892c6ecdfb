// How a picture at rest goes on to the truth: stages of 16, 64, 256 rays a pixel and more, or from 64 on, each a mean
// of frames whose rays are blurred for the number of the stage. A stage grows into the picture of the one before as its
// rays come in, in place of which it stands at its end. So an end is the same however it was reached, nothing jumps,
// and what two stages differ by tells how much is left. Arithmetic alone; called by PictureFrames, knows no graphics.
#pragma once

#include <vector>

#include "filters/vtk/draw/refined_rays.h"

namespace boxprobe {

struct RefineSettings {
  int rays = 0;        ///< a pixel, in the last stage; 0: no refinement
  double until = 0.0;  ///< relative error estimated to be left that is small enough; 0: only `rays` end it
  bool operator==(const RefineSettings& o) const { return rays == o.rays && until == o.until; }

  static constexpr int kRays = 256;
  static constexpr int kMostRays = 16384;
};

/// What a refined picture has come to.
struct RefineState {
  int rays = 0;        ///< of the last stage that is complete
  bool more = false;   ///< further rays are to come
  double left = -1.0;  ///< relative error of what rays can change that is estimated to be left; below 0: not known
};

/// How far apart two pictures are, over the pixels that differ at all.
struct PictureChange {
  double relativeRms = 0.0;   ///< root of the sum of squared differences over that of the squares
  double stepsOf8Bits = 0.0;  ///< of the 999th of 1000 pixels, in display colours
  bool operator==(const PictureChange& o) const {
    return relativeRms == o.relativeRms && stepsOf8Bits == o.stepsOf8Bits;
  }
};

class Refinement {
 public:
  /// Begins anew. `firstGuess`: how many rays the technique's own frame is worth.
  void begin(const RefineSettings& settings, int firstGuess);
  /// The stage at hand has all its frames. Goes on to the next, or ends.
  void endStage(const PictureChange& change);
  /// Are there frames to draw, after the technique's own one?
  bool more() const { return stage_ < stages_.size(); }

  /// Of the stage at hand.
  RefinedRays rays() const;
  int frames() const;
  /// The share of its mean in the picture, once it has so many frames.
  double share(int framesDone) const;

  /// Frames in all, and of the stages that are complete.
  int framesInAll() const;
  int framesBefore() const;
  int raysDone() const { return stage_ == 0 ? 0 : stages_[stage_ - 1]; }
  /// The relative error that is left after the last complete stage, of what rays can change; below 0: not known yet.
  double left() const { return left_; }
  /// A change this small does not show.
  static constexpr double kNothingShows = 0.5;

 private:
  std::vector<int> stages_;
  std::size_t stage_ = 0;
  RefineSettings settings_;
  int firstGuess_ = 1;
  double left_ = -1.0;
};

/// `before` and `after`: RGBA, linear.
PictureChange pictureChange(const std::vector<float>& before, const std::vector<float>& after, double exposure);

}  // namespace boxprobe
