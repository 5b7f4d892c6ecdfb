// What the draws of a scene renderer read in every pass: textures and lights of the current scene. Owns no texture.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <set>
#include <vector>

#include "filters/core/geometry/light_shadow.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/core/geometry/sky_openness.h"
#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/shared/display_math.h"
#include "filters/vtk/draw/lamp_block.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/listed_lights.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/maps/lattice_atlas.h"
#include "filters/vtk/maps/openness_texture.h"
#include "filters/vtk/maps/probe_maps.h"
#include "filters/vtk/maps/sight_atlas.h"

namespace boxprobe {

/// Size of the shadow maps of moving objects, texels.
constexpr int kMovingMapSize = 1024;
struct MovingShadow {
  int light = 0;
  GLuint texture = 0;
  glm::dmat4 mapFromWorld{1.0};
};
/// The shadow map of a directional light that asks for no shadows of its own: of objects that stand still. A light may
/// have two, one after the other: one of everything and a finer one around what stands on a wide ground.
struct SunShadow {
  int light = 0;
  GLuint texture = 0;  ///< 0: not drawn yet
  int size = 0;        ///< texels a side
  glm::dmat4 mapFromWorld{1.0};
  glm::vec2 apart{0.0f};     ///< taps of the filter, in the map's coordinates
  float off = 0.0f;          ///< distance from the surface at which the map is sampled, scene units
  std::vector<bool> shades;  ///< for each object: does this map have the shadows on it?
};
/// The apparent size of a light that casts shadows.
struct ShadowLight {
  LightSize size;
  float levelsPerUnit = -1.0f;  ///< negative: from its size; 0: the probe's own
};

struct SceneResources {
  std::shared_ptr<const ProbeMaps> sky;
  GLuint brdfTable = 0;
  LightForm lightForm = LightForm::Single;
  Tone tone = Tone::None;                   ///< of display colours; linear pictures and captures come before it
  bool foreign = false;                     ///< actors of another program: lamps have VTK's falloff
  bool emission = true;                     ///< emissive factors apply without an emissive texture
  GLuint blueNoise = 0;                     ///< RG32F, filters/math/sampling/blue_noise; made at the first use
  GLuint blackCube = 0;                     ///< replaces maps that are not captured yet
  GLuint viewColors = 0;                    ///< 256 x 1, for the debug view; made at the first use
  std::shared_ptr<const SceneLamps> lamps;  ///< null unless they are drawn as shapes
  /// Filters levels of a chain from its level 0. Set by the capturing object; does nothing without a context.
  std::function<void(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings)> filterLevels;
  std::shared_ptr<const SightLines> sightLines;           ///< through the static scene; null: not traced
  std::shared_ptr<const std::vector<Light>> looseLights;  ///< those that shine and for which no lamp stands
  bool latticesBeside = false;                            ///< frames do not wait for lattices (draw/probe_lattice.h)
  std::shared_ptr<LatticeAtlas> lattices = std::make_shared<LatticeAtlas>();
  std::shared_ptr<LampBlock> lampBlock = std::make_shared<LampBlock>();
  std::shared_ptr<SightAtlas> sights = std::make_shared<SightAtlas>();
  std::shared_ptr<const SkyOpenness> openness;  ///< null: all of the sky is open everywhere, or not traced yet
  std::shared_ptr<OpennessTexture> opennessTexture = std::make_shared<OpennessTexture>();
  std::vector<ShadowLight> shadowLights;  ///< in the order of the scene's lights
  std::vector<int> lightPlaces;           ///< of those among VTK's lights, -1: listed; empty: the same indices
  std::shared_ptr<ListedLights> listedLights = std::make_shared<ListedLights>();
  std::set<int> movingLightsInUse;  ///< indices of those whose shadows of moving objects a draw uses
  std::vector<MovingShadow> movingShadows;
  std::vector<SunShadow> sunShadows;
};

}  // namespace boxprobe
