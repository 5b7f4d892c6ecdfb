// A picture made in passes on all cores, each pass an independent estimate of every pixel: the mean is the picture, the
// spread its error.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Linear RGBA, alpha = coverage, with the standard error of the mean.
struct ReferencePicture {
  ImageRgbaF color;
  ImageRgbaF standardError;  ///< RGB; alpha is 0
  bool complete = true;      ///< false: stopped early; pixels then have the passes done so far, or none
};

/// A rectangle of pixels, from the top left; by default the whole picture.
struct PicturePart {
  int left = 0, top = 0;
  int right = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::max();  ///< one past the last
  PicturePart within(int width, int height) const;
};

/// The distribution of a pixel's rays: `raysPerPass` for each of its positions in each pass.
struct RayPlan {
  int passes = 8;
  int raysPerPass = 8;
};
/// For `rays` in total per pixel with `positions`: at least 8 per pass, so that few quotients have a small divisor, in
/// at most 16 passes, which are enough to estimate their spread.
RayPlan planRays(int rays, int positions);

/// Called with the finished fraction, 0 to 1, from different threads but never concurrently; returning false stops the
/// work.
using ReferenceProgress = std::function<bool(double)>;

class ProgressivePicture {
 public:
  ProgressivePicture(int width, int height);

  struct Pixel {
    glm::dvec3 color{0.0};
    double alpha = 0.0;
    bool exact = false;  ///< further passes would give the same
  };
  /// x, y from the top left. Must be thread-safe.
  using Estimate = std::function<Pixel(int x, int y, int pass)>;

  /// Computes only pixels of `part`; others stay as they are, initially black. Returns false if `progress` stopped it.
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
