// The GPU textures of a captured and prefiltered probe, and what is derived from them when a draw first needs it.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"
#include "filters/math/shared/lamp_math.h"
#include "filters/math/technique/levels_read.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/maps/derived_textures.h"
#include "filters/vtk/maps/flat_texture.h"
#include "filters/vtk/maps/lattice_maker.h"

namespace boxprobe {

/// The openings of a capture, for diffuse light (filters/math/cube/openings.h).
struct Openings {
  CubeMap reduced;   ///< the capture at a low resolution: radiance and, in alpha, coverage
  bool any = false;  ///< is any texel not entirely covered?
};

/// A prefiltered capture.
struct ProbeMaps {
  CubeTexture radiance;  ///< RGBA16F, prefiltered chain; level 0 is the capture itself; alpha = coverage
  CubeTexture distance;  ///< R32F: from the capture origin to what was seen, scene units; 0 where nothing was
  ShCoefficients irradiance{};
  glm::dvec3 capturedAt{0.0};
  /// Rotation of the box, in degrees, along whose axes the maps lie; irradiance is along the world's.
  glm::dvec3 capturedRotation{0.0};
  /// Shown until others are there: no lattice is derived from them.
  bool forTheTimeBeing = false;
  float maxLevel() const { return static_cast<float>(radiance.levels() - 1); }
  /// The levels of `radiance` that are filtered. Others hold plain means of the capture until something needs them; a
  /// lookup that comes too early may show these.
  mutable LevelMask filtered = kAllLevels;
  /// Filters the levels of a mask; false if the filter was destroyed. Null: no level is missing.
  std::function<bool(const ProbeMaps& maps, LevelMask levels)> filterLevels;
  LevelMask missing(LevelMask levels) const { return levels & ~filtered & ((LevelMask{1} << radiance.levels()) - 1); }
  /// Filters those of the levels that are missing; needs the window's context current.
  void need(LevelMask levels) const {
    const LevelMask wanted = missing(levels);
    if (wanted == 0 || !filterLevels) return;
    if (!filterLevels(*this, wanted)) return;
    filtered |= wanted;
    flat.release();
  }
  /// Made at the first draw with a program that samples it (flat_texture.h).
  mutable FlatTexture flat;
  /// Made when a draw first aims rays by brightness (derived_textures.h).
  mutable LightTexture light;
  /// Made when a draw first follows rays by distances (derived_textures.h).
  mutable ReliefTexture relief;
  /// Made when a draw first needs diffuse light (lattice_maker.h).
  mutable LatticeMaker lattice;
  /// Made when a rough surface first draws lamps as shapes (lamp_free_maps.h).
  struct LampFree {
    std::shared_ptr<ProbeMaps> maps;     ///< only a chain; null: not made
    std::vector<LampPolygon> of;         ///< the lamps removed from it
    std::vector<glm::vec3> backgrounds;  ///< of each, what stands in its place (lampBackgrounds)
    bool refused = false;
  };
  mutable LampFree lampFree;
  /// Made when a probe through which the sky shows first uses these maps.
  mutable std::shared_ptr<const Openings> openings;
  /// Made when a draw first needs a light's transmittance.
  mutable CoverageTexture coverage;
  mutable std::shared_ptr<const CubeMap> tint;  ///< of visible glass (glass_tint.h); null: none
  std::size_t bytes() const {
    return radiance.bytes() + distance.bytes() + flat.bytes() + light.bytes() + relief.bytes() + coverage.bytes() +
           (lampFree.maps ? lampFree.maps->bytes() : 0);
  }
};

}  // namespace boxprobe
