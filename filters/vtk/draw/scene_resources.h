// What the draws of a scene renderer read whatever the pass: textures and lights of the scene as it stands. Filled by
// the renderer, the probe set and the passes that make them; read when surfaces are drawn. Plain data; owns no texture.
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
#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/shared/display_math.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/maps/lattice_atlas.h"
#include "filters/vtk/maps/probe_maps.h"
#include "filters/vtk/maps/sight_atlas.h"

namespace boxprobe {

/// Side of the maps of what moves, texels.
constexpr int kMovingMapSize = 1024;
struct MovingShadow {
  int light = 0;
  GLuint texture = 0;
  glm::dmat4 mapFromWorld{1.0};
};
/// Of a directional light that asks for no shadows of its own: what stands still before it.
struct SunShadow {
  int light = 0;
  GLuint texture = 0;  ///< 0: not drawn yet
  int size = 0;        ///< texels a side
  glm::dmat4 mapFromWorld{1.0};
  glm::vec2 apart{0.0f};     ///< taps of the filter, in the map's coordinates
  float off = 0.0f;          ///< how far off a surface the map is looked up, scene units
  std::vector<bool> shades;  ///< of each object: may anything throw its shadow there?
};
/// What a light that asks for shadows looks like.
struct ShadowLight {
  LightSize size;
  float levelsPerUnit = -1.0f;  ///< negative: by its size; 0: the probe's own
};

struct SceneResources {
  std::shared_ptr<const ProbeMaps> sky;
  GLuint brdfTable = 0;
  LightForm lightForm = LightForm::Single;
  Tone tone = Tone::None;                   ///< of display colours; linear pictures and captures are before it
  bool foreign = false;                     ///< somebody else's actors: falloffs of lamps mean what they mean in VTK
  bool emission = true;                     ///< emissive factors show without an emissive texture
  GLuint blueNoise = 0;                     ///< RG32F, filters/math/sampling/blue_noise; made when a draw first uses it
  GLuint blackCube = 0;                     ///< stands in for maps not captured yet
  GLuint viewColors = 0;                    ///< 256 x 1, of the debug view; made when that is first shown
  std::shared_ptr<const SceneLamps> lamps;  ///< null unless they are drawn as shapes
  /// Filters levels of a chain from its level 0. Set by who captures; does nothing without a context.
  std::function<void(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings)> filterLevels;
  std::shared_ptr<const SightLines> sightLines;           ///< through the scene as it stands still; null: not traced
  std::shared_ptr<const std::vector<Light>> looseLights;  ///< those that shine and are not counted with a lamp
  bool latticesBeside = false;                            ///< frames do not wait for lattices (draw/probe_lattice.h)
  std::shared_ptr<LatticeAtlas> lattices = std::make_shared<LatticeAtlas>();
  std::shared_ptr<SightAtlas> sights = std::make_shared<SightAtlas>();
  std::vector<ShadowLight> shadowLights;  ///< in the order of the scene's lights
  std::set<int> movingLightsInUse;        ///< those whose shadows of what moves some draw asks for
  std::vector<MovingShadow> movingShadows;
  std::vector<SunShadow> sunShadows;
};

}  // namespace boxprobe
