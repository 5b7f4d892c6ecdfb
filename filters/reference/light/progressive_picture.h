// A picture made in passes on all cores, each pass an independent estimate of every pixel: their mean is the picture,
// their spread says how far it is off. Called by both references; knows neither scenes nor rays.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Linear RGBA, alpha = coverage, with the standard error of the mean beside it.
struct ReferencePicture {
  ImageRgbaF color;
  ImageRgbaF standardError;  ///< RGB; alpha is 0
  bool complete = true;      ///< false: stopped early; a pixel then holds the passes it has had, or nothing
};

/// Pixels of a picture, from the top left; the default is all of them.
struct PicturePart {
  int left = 0, top = 0;
  int right = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::max();  ///< one past the last
  PicturePart within(int width, int height) const;
};

/// How a pixel's rays are divided: `raysPerPass` for each of its positions in each pass.
struct RayPlan {
  int passes = 8;
  int raysPerPass = 8;
};
/// `rays` in all for a pixel of `positions`: 8 a pass at least, so that few quotients have a small divisor, in at most
/// 16 passes, which are enough to judge their spread by.
RayPlan planRays(int rays, int positions);

/// Called with what is done, 0..1, now from one thread, now from another, never from two at once; false stops the work.
using ReferenceProgress = std::function<bool(double)>;

class ProgressivePicture {
 public:
  ProgressivePicture(int width, int height);

  struct Pixel {
    glm::dvec3 color{0.0};
    double alpha = 0.0;
    bool exact = false;  ///< any further pass would give the same
  };
  /// x, y from the top left. Asked from many threads at once.
  using Estimate = std::function<Pixel(int x, int y, int pass)>;

  /// Pixels of `part` alone; the others stay as they are, black at first. Returns false if `progress` stopped it.
  bool run(const PicturePart& part, int passes, const Estimate& estimate, const ReferenceProgress& progress);

  ReferencePicture picture() const;

 private:
  struct Sum {
    glm::dvec3 mean{0.0}, squares{0.0};  ///< of the passes; sum of squared deviations from the mean (Welford 1962)
    double alpha = 0.0;
    int count = 0;
    bool exact = false;
  };
  int width_, height_;
  bool complete_ = true;
  std::vector<Sum> sums_;
};

}  // namespace boxprobe
