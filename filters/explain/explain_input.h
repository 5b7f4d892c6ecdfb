// All inputs of a pixel's explanation: the surface, the draw's probes with their maps, lights, glass, mirror.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sky_openness.h"
#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/scene.h"
#include "filters/core/surface/surface_point.h"
#include "filters/explain/explain_glass.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/shared/mirror_math.h"

namespace boxprobe {

/// A probe of the draw, most important first.
struct ExplainedProbe {
  std::string name;
  int index = 0;                      ///< in the scene's list
  int group = 0;                      ///< of equal importance, from 0
  ProbeGeometry geometry;             ///< with the technique that draws it
  const BakedMaps* maps = nullptr;    ///< null: not captured yet
  bool automatic = false;             ///< its technique was chosen by the object's roughness
  bool open = false;                  ///< the sky shows where the probe saw nothing
  ShCoefficients openSky{};           ///< diffuse light of the sky through openings
  const CubeMap* coverage = nullptr;  ///< transmittance, in levels of plain means; null: unknown yet
  std::uint32_t shadowLights = 0;     ///< one bit per light that its coverage shadows
  /// Used in place of the maps' coefficients, with the lamps below; null: the coefficients are used. Includes the sky
  /// through openings.
  std::shared_ptr<const DiffuseLattice> lattice = {};
  std::vector<SceneLamp> lamps = {};             ///< drawn as shapes
  std::vector<glm::vec3> lampGlossy = {};        ///< of each, its radiance less what stands in its place in `lampFree`
  std::shared_ptr<const ProbeSight> sight = {};  ///< visibility of lamps and light sources; null: all visible
  std::vector<int> lampChannels = {};            ///< of each of `lamps` in `sight`
  /// Sampled by rough surfaces in place of `maps`: without those lamps, with the mean of the lamps' colours in alpha.
  /// Null: `maps` is sampled.
  const BakedMaps* lampFree = nullptr;
  const BakedMaps* lookedUp() const { return lampFree != nullptr ? lampFree : maps; }
};

/// A depth map from a light: of moving objects, or of those that stand still before a sun.
struct MovingMap {
  int light = 0;
  int size = 0;
  /// Rows from the bottom. Shared: a map has megabytes, and each pixel its own input.
  std::shared_ptr<const std::vector<float>> depth;
  glm::dmat4 mapFromWorld{1.0};
  glm::dvec2 apart{0.0};  ///< taps of its filter, in the map's coordinates
  double off = 0.0;       ///< how far off the surface it is looked up, scene units
};

struct ExplainInput {
  SurfacePoint surface;
  enum class Lighting { Plain, Unlit, Probes } lighting = Lighting::Probes;
  std::vector<ExplainedProbe> probes;
  bool weights = true;        ///< false: one probe at full weight, nothing left for the sky
  bool sky = true;            ///< false: the sky gets no share
  bool diffuse = true;        ///< false: the material is all metal
  bool onlyProbes = false;    ///< probes share the sky's part, wherever one has weight
  std::vector<float> shares;  ///< for the whole object, in place of weights at the point; empty: those are used
  float skyShare = 1.0f;      ///< with `shares`
  const BakedMaps* skyMaps = nullptr;
  std::shared_ptr<const SkyOpenness> openness = {};  ///< how much of it the scene leaves open; null: all
  Energy energy = Energy::Single;
  std::vector<Light> lights;
  std::optional<ExplainedGlass> glass;  ///< of a surface that is drawn as glass
  /// The planar mirror whose picture is shown, relative to the eye, with its texels; null: none.
  const shading::MirrorLook* mirror = nullptr;
  std::vector<int> shadowLights;  ///< those for which this draw samples a probe's coverage
  std::vector<MovingMap> movingMaps;
  std::vector<MovingMap> sunMaps;  ///< of suns for which this draw samples one
  std::vector<int> sightLights;    ///< those not visible from everywhere in a probe's box
};

}  // namespace boxprobe
