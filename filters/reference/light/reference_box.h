// The world as box projection has it, integrated: what a lobe reflects of what the probe's own unfiltered capture shows
// where its rays meet the box, in double precision. What is left of a technique's error against this is the technique's
// alone: neither the box's nor the capture's. Called by the command line, the benchmark and tests, with points that say
// what the surface is and which probes light it; knows no GL.
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

/// What a probe holds where a ray meets its box.
class BoxWorld {
 public:
  /// `radiance`: the probe's chain, of which level 0 is read; it must outlive this. Box and position are the
  /// point's.
  BoxWorld(const ProbeAtPoint& probe, const CubeMap& radiance);

  /// `directionWorld` unit. The exit from the box; a position outside counts as on the nearest face.
  glm::dvec3 radiance(const glm::dvec3& directionWorld) const;
  /// That point along the axes of the probe's maps, relative to the capture origin.
  glm::dvec3 hit(const glm::dvec3& directionWorld) const;

  /// The unit direction, world, from here to where the box is met by a direction (not unit) from the capture origin,
  /// along the axes of its maps.
  glm::dvec3 towards(const glm::dvec3& fromOriginMap) const;
  /// Solid angle about the capture origin of the patch of wall in that direction, over that about here: carries a
  /// density over. `fromOriginMap`: the patch as the origin sees it.
  double magnification(const glm::dvec3& directionWorld, glm::dvec3* fromOriginMap) const;
  /// Those two are each other's inverse only seen from inside the box, with the capture made inside of it.
  bool convex() const;

 private:
  glm::dvec3 exit(const glm::dvec3& from, const glm::dvec3& direction, int* axis) const;

  const CubeMap& map_;
  glm::dmat3 worldFromProbe_, mapFromProbe_;
  glm::dvec3 position_, low_, high_;  ///< probe frame
};

struct ReferenceBoxMaps {
  std::vector<std::shared_ptr<const BakedMaps>> probes;  ///< in the scene's order; null: gives nothing
  std::shared_ptr<const BakedMaps> sky;                  ///< null: black
  /// Of each probe, where its light stands out; empty: rays are drawn by the lobe alone, which needs far more of them
  /// where lamps are small.
  std::vector<std::shared_ptr<const BrightDirections>> bright;

  Energy energy = Energy::Single;  ///< the scene's

  void findBright();  ///< fills `bright` from `probes`
};

/// All that a pixel's probes and the sky show it, as one world.
class BoxSurroundings {
 public:
  /// Both must outlive this.
  BoxSurroundings(const LitPoint& pixel, const ReferenceBoxMaps& maps);
  bool empty() const { return parts_.empty() && skyShare_ <= 0.0; }
  glm::dvec3 radiance(const glm::dvec3& directionWorld) const;

  /// What the layer reflects of it, as lobeReflected() has it. What stands out in a capture is summed apart, over
  /// directions drawn both by the lobe and towards it. `lobe`: the layer's.
  glm::dvec3 reflected(const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays, std::uint64_t seed) const;

  /// What a direction shows, in two parts.
  struct Light {
    glm::dvec3 even{0.0};    ///< found by the lobe's own rays: exact for a constant
    glm::dvec3 bright{0.0};  ///< found by those and by rays towards lamps, weighed by the balance heuristic (Veach and
                             ///< Guibas 1995); all of it must lie where lamps are for that to be of use
  };
  /// The same of any light.
  glm::dvec3 reflectedOf(const std::function<Light(const glm::dvec3& directionWorld)>& light,
                         const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays,
                         std::uint64_t seed) const;

 private:
  struct Part {
    BoxWorld world;
    double share;
    const BrightDirections* bright;  ///< null: none, or not to be drawn towards from here
  };
  Light light(const glm::dvec3& directionWorld) const;
  /// How likely rays are drawn towards each group of each part, one after the other, summed up: by the light that the
  /// surface reflects of its middle.
  std::vector<double> lampChances(const VisibleNormalLobe& lobe) const;
  glm::dvec3 towardsLamp(const std::vector<double>& chances, const glm::dvec2& u) const;
  double lampDensity(const std::vector<double>& chances, const glm::dvec3& directionWorld) const;

  std::vector<Part> parts_;
  std::size_t groups_ = 0;  ///< of all parts
  const CubeMap* sky_ = nullptr;
  double skyShare_ = 0.0;
};

/// One estimate of the colour of a pixel, all of whose probes are taken as box worlds whatever their
/// technique, the sky as it is. Everything but reflections is the point's own. `exact`: says whether another seed
/// would give the same. Mean of estimates with independent seeds: the reference; their spread: its standard error.
glm::dvec3 referenceBoxColor(const LitPoint& pixel, const ReferenceBoxMaps& maps, int rays, std::uint64_t seed,
                             bool* exact = nullptr);

}  // namespace boxprobe
