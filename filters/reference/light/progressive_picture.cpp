#include "filters/reference/light/progressive_picture.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace boxprobe {

PicturePart PicturePart::within(int width, int height) const {
  PicturePart part;
  part.left = std::clamp(left, 0, width);
  part.top = std::clamp(top, 0, height);
  part.right = std::clamp(right, part.left, width);
  part.bottom = std::clamp(bottom, part.top, height);
  return part;
}

RayPlan planRays(int rays, int positions) {
  constexpr int kLeastRays = 8, kMostPasses = 16;
  const int each = std::max(rays / positions, 1);
  const int passes = std::clamp(each / kLeastRays, std::min(each, 2), kMostPasses);
  return {passes, std::max(each / passes, 1)};
}

ProgressivePicture::ProgressivePicture(int width, int height)
    : width_(width), height_(height), sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

bool ProgressivePicture::run(const PicturePart& part, int passes, const Estimate& estimate,
                             const ReferenceProgress& progress) {
  constexpr int kTile = 16;
  const double whole = static_cast<double>(part.bottom - part.top) * (part.right - part.left) * passes;
  std::atomic<bool> stopped{false};
  std::mutex reporting;
  double done = 0.0;
  for (int pass = 0; pass < passes && !stopped; ++pass) {
    using Tile = tbb::blocked_range2d<int>;
    const auto work = [&](const Tile& tile) {
      for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
        for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
          if (stopped) return;
          Sum& sum =
              sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
          if (sum.exact) continue;
          const Pixel pixel = estimate(x, y, pass);
          ++sum.count;
          const glm::dvec3 change = pixel.color - sum.mean;
          sum.mean += change / static_cast<double>(sum.count);
          sum.squares += change * (pixel.color - sum.mean);
          sum.alpha = pixel.alpha;
          sum.exact = pixel.exact;
        }
      }
      const std::lock_guard<std::mutex> lock(reporting);
      done += static_cast<double>(tile.rows().size()) * static_cast<double>(tile.cols().size());
      if (progress && !stopped && !progress(done / whole)) stopped = true;
    };
    tbb::parallel_for(Tile(part.top, part.bottom, kTile, part.left, part.right, kTile), work,
                      tbb::simple_partitioner());
  }
  complete_ = complete_ && !stopped;
  return !stopped;
}

ReferencePicture ProgressivePicture::picture() const {
  ReferencePicture result;
  result.complete = complete_;
  for (ImageRgbaF* image : {&result.color, &result.standardError}) {
    image->width = width_;
    image->height = height_;
    image->pixels.assign(4 * sums_.size(), 0.0f);
  }
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Sum& sum = sums_[i];
    for (int c = 0; c < 3; ++c) {
      result.color.pixels[4 * i + static_cast<std::size_t>(c)] = static_cast<float>(sum.mean[c]);
      if (sum.count < 2) continue;
      const double variance = std::max(sum.squares[c], 0.0) / (sum.count - 1);
      result.standardError.pixels[4 * i + static_cast<std::size_t>(c)] =
          static_cast<float>(std::sqrt(variance / sum.count));
    }
    result.color.pixels[4 * i + 3] = static_cast<float>(sum.alpha);
  }
  return result;
}

}  // namespace boxprobe
