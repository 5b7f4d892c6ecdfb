// The world that box projection assumes, integrated in double precision: what a lobe reflects if its rays see, at their
// hits on the box, the probe's own unfiltered capture. The difference of a technique from this is its own error,
// without the box's and the capture's.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "filters/core/picture/baked_probe.h"
#include "filters/core/surface/lit_point.h"
#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/trace/bright_directions.h"
#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

/// The world of one probe: its capture on its box.
class BoxWorld {
 public:
  /// `radiance`: the probe's chain, of which level 0 is read; it must outlive this object. Box and position are the
  /// point's.
  BoxWorld(const ProbeAtPoint& probe, const CubeMap& radiance);

  /// `directionWorld` unit. The radiance at the exit from the box; a position outside counts as on the nearest face.
  glm::dvec3 radiance(const glm::dvec3& directionWorld) const;
  /// The exit along the axes of the probe's maps, relative to the capture origin.
  glm::dvec3 hit(const glm::dvec3& directionWorld) const;

  /// The unit direction, world, from this position to where a direction (not unit) from the capture origin, along the
  /// axes of its maps, meets the box.
  glm::dvec3 towards(const glm::dvec3& fromOriginMap) const;
  /// Solid angle of the patch of wall in that direction as seen from the capture origin, over that from here: converts
  /// a density. `fromOriginMap`: the direction of the patch from the origin.
  double magnification(const glm::dvec3& directionWorld, glm::dvec3* fromOriginMap) const;
  /// Those two are inverses only if the position and the capture origin are inside the box.
  bool convex() const;

 private:
  glm::dvec3 exit(const glm::dvec3& from, const glm::dvec3& direction, int* axis) const;

  const CubeMap& map_;
  glm::dmat3 worldFromProbe_, mapFromProbe_;
  glm::dvec3 position_, low_, high_;  ///< probe frame
};

struct ReferenceBoxMaps {
  std::vector<std::shared_ptr<const BakedMaps>> probes;  ///< in the scene's order; null: no light
  std::shared_ptr<const BakedMaps> sky;                  ///< null: black
  /// The bright directions of each probe; empty: rays follow the lobe alone, which needs far more of them for small
  /// lamps.
  std::vector<std::shared_ptr<const BrightDirections>> bright;

  Energy energy = Energy::Single;  ///< the scene's

  void findBright();  ///< fills `bright` from `probes`
};

/// The surroundings of a pixel, with all of its probes and the sky.
class BoxSurroundings {
 public:
  /// Both arguments must outlive this object.
  BoxSurroundings(const LitPoint& pixel, const ReferenceBoxMaps& maps);
  bool empty() const { return parts_.empty() && skyShare_ <= 0.0; }
  glm::dvec3 radiance(const glm::dvec3& directionWorld) const;

  /// The light that the layer reflects, as in lobeReflected(). Light above the threshold of a capture is summed
  /// separately, over directions from the lobe and towards it. `lobe`: the layer's.
  glm::dvec3 reflected(const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays, std::uint64_t seed) const;

  /// The radiance of a direction, in two parts.
  struct Light {
    glm::dvec3 even{0.0};    ///< sampled by the lobe: exact for a constant
    glm::dvec3 bright{0.0};  ///< sampled by the lobe and towards lamps, weighted by the balance heuristic (Veach and
                             ///< Guibas 1995); useful if all of it is where lamps are
  };
  /// The same for any light.
  glm::dvec3 reflectedOf(const std::function<Light(const glm::dvec3& directionWorld)>& light,
                         const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays,
                         std::uint64_t seed) const;

 private:
  struct Part {
    BoxWorld world;
    double share;
    const BrightDirections* bright;  ///< null: none, or sampling towards them is impossible from here
  };
  Light light(const glm::dvec3& directionWorld) const;
  /// Cumulative probability of rays towards the groups of all parts: by the light that the surface reflects from the
  /// middle of a group.
  std::vector<double> lampChances(const VisibleNormalLobe& lobe) const;
  glm::dvec3 towardsLamp(const std::vector<double>& chances, const glm::dvec2& u) const;
  double lampDensity(const std::vector<double>& chances, const glm::dvec3& directionWorld) const;

  std::vector<Part> parts_;
  std::size_t groups_ = 0;  ///< total of all parts
  const CubeMap* sky_ = nullptr;
  double skyShare_ = 0.0;
};

/// One estimate of a pixel's colour with every probe as a box world, whatever its technique, and the sky as it is.
/// Everything except reflections is the point's own. `exact`: would another seed give the same? The mean of estimates
/// with independent seeds is the reference; their spread gives its standard error.
glm::dvec3 referenceBoxColor(const LitPoint& pixel, const ReferenceBoxMaps& maps, int rays, std::uint64_t seed,
                             bool* exact = nullptr);

}  // namespace boxprobe
