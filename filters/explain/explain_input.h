// Everything the explanation of a pixel is calculated from: the surface, the draw's probes with their maps, lights,
// glass, mirror. Plain values; filled by the surface inspector, read by explain_pixel and explain_shadow.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/scene_lamps.h"
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
  ProbeGeometry geometry;             ///< its technique is what draws it
  const BakedMaps* maps = nullptr;    ///< null: not captured yet
  bool automatic = false;             ///< its technique was chosen for the object's roughness
  bool open = false;                  ///< the sky shows where it saw nothing
  ShCoefficients openSky{};           ///< its diffuse light that comes in there
  const CubeMap* coverage = nullptr;  ///< what it lets through, in levels of plain means; null: not known yet
  std::uint32_t shadowLights = 0;     ///< a bit for each light that its coverage stands before
  /// In place of the maps' coefficients, with its lamps; null: those. The sky through openings is in it.
  std::shared_ptr<const DiffuseLattice> lattice = {};
  std::vector<SceneLamp> lamps = {};             ///< drawn as shapes
  std::shared_ptr<const ProbeSight> sight = {};  ///< what is seen of them and of light sources; null: all
  std::vector<int> lampChannels = {};            ///< of each of `lamps` in `sight`
  /// What a rough surface looks up in place of `maps`: without those lamps, the mean of their colours in alpha. Null:
  /// `maps`.
  const BakedMaps* lampFree = nullptr;
  const BakedMaps* lookedUp() const { return lampFree != nullptr ? lampFree : maps; }
};

/// A depth map as a light sees it: of what moves, or of what stands still before a sun.
struct MovingMap {
  int light = 0;
  int size = 0;
  std::vector<float> depth;  ///< rows from the bottom
  glm::dmat4 mapFromWorld{1.0};
  glm::dvec2 apart{0.0};  ///< taps of its filter, in the map's coordinates
  double off = 0.0;       ///< how far off the surface it is looked up, scene units
};

struct ExplainInput {
  SurfacePoint surface;
  enum class Lighting { Plain, Unlit, Probes } lighting = Lighting::Probes;
  std::vector<ExplainedProbe> probes;
  bool weights = true;        ///< false: one probe at full weight, nothing left for the sky
  bool sky = true;            ///< false: the probes leave nothing to it
  bool onlyProbes = false;    ///< what they leave to it goes to them, wherever one has weight
  std::vector<float> shares;  ///< of all of the object, in place of weights at the point; empty: those
  float skyShare = 1.0f;      ///< beside `shares`
  const BakedMaps* skyMaps = nullptr;
  Energy energy = Energy::Single;
  std::vector<Light> lights;
  std::optional<ExplainedGlass> glass;  ///< of a surface that is drawn as such
  /// Of a planar mirror whose picture is shown, relative to the eye, its texels read back; null: none.
  const shading::MirrorLook* mirror = nullptr;
  std::vector<int> shadowLights;  ///< those that this draw asks a probe's coverage about
  std::vector<MovingMap> movingMaps;
  std::vector<MovingMap> sunMaps;  ///< of suns that this draw asks them about
  std::vector<int> sightLights;    ///< those that some place of a probe's box does not see whole
};

}  // namespace boxprobe
