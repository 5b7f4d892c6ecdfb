// A captured and prefiltered probe on the graphics side: the cube maps that lookups read, with what is made from them
// when a draw first asks. Filled by captures and files, read by draws; knows no scene.
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
#include "filters/vtk/maps/coverage_texture.h"
#include "filters/vtk/maps/flat_texture.h"
#include "filters/vtk/maps/lattice_maker.h"
#include "filters/vtk/maps/light_texture.h"
#include "filters/vtk/maps/relief_texture.h"

namespace boxprobe {

/// What a capture left open, for diffuse light (filters/math/cube/openings.h).
struct Openings {
  CubeMap reduced;   ///< the capture in few texels: radiance and, in alpha, coverage
  bool any = false;  ///< is any texel not wholly covered?
};

/// A capture, prefiltered: what lookups read.
struct ProbeMaps {
  CubeTexture radiance;  ///< RGBA16F, prefiltered chain; level 0 is the capture itself; alpha = coverage
  CubeTexture distance;  ///< R32F: from the capture origin to what was seen, scene units; 0 where nothing was
  ShCoefficients irradiance{};
  glm::dvec3 capturedAt{0.0};
  /// Of the box, in degrees: the maps lie along the axes it had; irradiance along the world's.
  glm::dvec3 capturedRotation{0.0};
  /// Shown until others are there: no lattice is derived from them.
  bool forTheTimeBeing = false;
  float maxLevel() const { return static_cast<float>(radiance.levels() - 1); }
  /// Levels of `radiance` that are filtered. The others hold plain means of the capture, which a lookup that comes too
  /// early may show, until something needs them.
  mutable LevelMask filtered = kAllLevels;
  /// Filters the levels of a mask; false: what filters is gone. Null: none is missing.
  std::function<bool(const ProbeMaps& maps, LevelMask levels)> filterLevels;
  LevelMask missing(LevelMask levels) const { return levels & ~filtered & ((LevelMask{1} << radiance.levels()) - 1); }
  /// Filters those of these levels that are missing; with the window's context current.
  void need(LevelMask levels) const {
    const LevelMask wanted = missing(levels);
    if (wanted == 0 || !filterLevels) return;
    if (!filterLevels(*this, wanted)) return;
    filtered |= wanted;
    flat.release();
  }
  /// Made when a program that looks it up is first drawn with (flat_texture.h).
  mutable FlatTexture flat;
  /// Made when a draw first aims rays at what is bright (light_texture.h).
  mutable LightTexture light;
  /// Made when a draw first follows rays by the distances (relief_texture.h).
  mutable ReliefTexture relief;
  /// Made when a draw first asks for diffuse light at a place (lattice_maker.h).
  mutable LatticeMaker lattice;
  /// Made when a rough surface first shows lamps as shapes (lamp_free_maps.h).
  struct LampFree {
    std::shared_ptr<ProbeMaps> maps;  ///< a chain alone; null: not made
    std::vector<LampPolygon> of;      ///< what does not show in it
    bool refused = false;
  };
  mutable LampFree lampFree;
  /// Made when a probe that lets the sky through first shows these maps.
  mutable std::shared_ptr<const Openings> openings;
  /// Made when a draw first asks what a light shines through.
  mutable CoverageTexture coverage;
  mutable std::shared_ptr<const CubeMap> tint;  ///< of the glass it shows (glass_tint.h); null: there is none
  std::size_t bytes() const {
    return radiance.bytes() + distance.bytes() + flat.bytes() + light.bytes() + relief.bytes() + coverage.bytes() +
           (lampFree.maps ? lampFree.maps->bytes() : 0);
  }
};

}  // namespace boxprobe
