// What every draw of a scene renderer needs to know: shared by the renderer and the passes (which fill it) and the
// mappers (which read it when they draw). Plain data.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "filters/core/base/counters.h"
#include "filters/core/geometry/light_shadow.h"
#include "filters/vtk/maps/probe_maps.h"
#include "filters/vtk/surface/probe_binding.h"

namespace boxprobe {

/// What the debug view's programs show.
struct DebugDraw {
  int view = 0;  ///< row of surfaceViews()
  float low = 0.0f, high = 1.0f;
  GLuint colorMap = 0;  ///< 256 x 1
};

/// Side of the maps of what moves, texels.
constexpr int kMovingMapSize = 1024;
struct MovingShadow {
  int light = 0;
  GLuint texture = 0;
  glm::dmat4 mapFromWorld{1.0};
};
/// What a light that asks for shadows looks like.
struct ShadowLight {
  LightSize size;
  float levelsPerUnit = -1.0f;  ///< negative: by its size; 0: the probe's own
};

/// One for all mappers of a scene renderer.
struct DrawState {
  float exposure = 1.0f;     ///< negative: linear output
  bool dragging = false;     ///< a handle is held: uniforms change, and nothing is worked out for them
  bool firstBounce = false;  ///< of a capture: probes reflect nothing yet, and the sky lights in their place
  std::shared_ptr<const ProbeMaps> sky;
  GLuint brdfTable = 0;
  GLuint blueNoise = 0;  ///< RG32F, filters/math/blue_noise; made when a draw first uses it
  GLuint blackCube = 0;  ///< stands in for maps not captured yet
  Counters counters;
  DebugDraw debug;
  std::vector<ShadowLight> shadowLights;  ///< in the order of the scene's lights
  std::set<int> shadowLightsInUse;        ///< of them, those that some draw asks about
  std::vector<MovingShadow> movingShadows;
  bool movingShadowsOn = true;  ///< not in captures of what stands still
  glm::ivec2 pixelOrigin{0};    ///< where in the picture the framebuffer's lower left lies
  int frame = 0;                ///< of those that are averaged
  glm::vec4 heightPlaneView{
      0.0f};                       ///< of the mirror whose picture is being drawn, view space; see mirrored_output.glsl
  bool countDraws = true;          ///< of the frame on the screen, not of captures
  std::set<const void*> programs;  ///< seen so far, to count compilations
  std::string error;               ///< first failure since the models were set
};

}  // namespace boxprobe
