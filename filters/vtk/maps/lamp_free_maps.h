// A probe's chain in which lamps that are drawn as shapes do not show: what rough surfaces look up. Alpha, which is
// coverage in the probe's own chain, holds the lamps' light, the mean of its colours, so that one lookup gives both.
// Made when a draw first asks for it. Called by the probe pass, with the window's context current; knows no scene.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "filters/math/shared/lamp_math.h"
#include "filters/math/technique/levels_read.h"

namespace boxprobe {

class CubeTexture;
struct ProbeMaps;

class LampFreeMaps {
 public:
  /// Filters the levels of a mask from a chain's level 0.
  using Filter = std::function<void(const CubeTexture& chain, LevelMask levels)>;

  /// Makes them without `lamps` (relative to the capture origin, along the map's axes), unless they are there, and
  /// those of `levels` that are missing. Made again for other lamps, but not while a box is `dragged`. Of the maps,
  /// `radiance` and `distance` are read. False: there is no memory for them.
  bool make(const ProbeMaps& maps, const std::vector<LampPolygon>& lamps, LevelMask levels, bool dragged,
            const Filter& filter);
  /// Null before the first make(). A chain alone: distances and diffuse light are the probe's own.
  std::shared_ptr<const ProbeMaps> latest() const { return maps_; }
  std::size_t bytes() const;

 private:
  std::vector<LampPolygon> lamps_;
  std::shared_ptr<ProbeMaps> maps_;
  bool refused_ = false;
};

}  // namespace boxprobe
