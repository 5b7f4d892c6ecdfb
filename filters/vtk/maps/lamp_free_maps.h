// A probe's chain in which lamps that are drawn as shapes do not show: what rough surfaces look up. Alpha, which is
// coverage in the probe's own chain, holds the lamps' light, so that one lookup gives both. Made when a draw first asks
// for it. Called by the probe pass, with the window's context current; knows no scene.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "filters/math/shared/lamp_math.h"
#include "filters/math/technique/levels_read.h"

namespace boxprobe {

class CubeTexture;
struct ProbeMaps;

/// A lamp as such maps know it.
struct MapLamp {
  LampPolygon shape;  ///< relative to the capture origin, along the map's axes
  glm::vec3 radiance{0.0f};
};

class LampFreeMaps {
 public:
  /// Filters the levels of a mask from a chain's level 0.
  using Filter = std::function<void(const CubeTexture& chain, LevelMask levels)>;

  /// Makes them without `lamps`, unless they are there, and those of `levels` that are missing. Made again for other
  /// lamps, but not while a box is `dragged`. Of the maps, `radiance` and `distance` are read. False: there is no
  /// memory for them.
  bool make(const ProbeMaps& maps, const std::vector<MapLamp>& lamps, LevelMask levels, bool dragged,
            const Filter& filter);
  /// Null before the first make(). A chain alone: distances and diffuse light are the probe's own.
  std::shared_ptr<const ProbeMaps> latest() const { return maps_; }
  /// What alpha is to be multiplied by: colour of the lamps, the largest component 1.
  glm::vec3 tint() const { return tint_; }
  std::size_t bytes() const;

 private:
  std::vector<MapLamp> lamps_;
  std::shared_ptr<ProbeMaps> maps_;
  glm::vec3 tint_{0.0f};
  bool refused_ = false;
};

}  // namespace boxprobe
