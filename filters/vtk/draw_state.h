// What a draw needs to know of the probes: shared by the scene renderer (which fills it) and the mappers (which read it
// when they draw). Plain data.
#pragma once

#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/counters.h"
#include "filters/core/light_shadow.h"
#include "filters/core/probe_geometry.h"
#include "filters/math/automatic.h"
#include "filters/math/cube_map.h"
#include "filters/math/spherical_harmonics.h"
#include "filters/vtk/coverage_texture.h"
#include "filters/vtk/gl_objects.h"
#include "filters/vtk/light_texture.h"
#include "filters/vtk/relief_texture.h"

namespace boxprobe {

/// What a capture left open, for diffuse light (filters/math/openings.h).
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
  float maxLevel() const { return static_cast<float>(radiance.levels() - 1); }
  /// Made when a draw first aims rays at what is bright (light_texture.h).
  mutable LightTexture light;
  /// Made when a draw first follows rays by the distances (relief_texture.h).
  mutable ReliefTexture relief;
  /// Made when a probe that lets the sky through first shows these maps.
  mutable std::shared_ptr<const Openings> openings;
  /// Made when a draw first asks what a light shines through.
  mutable CoverageTexture coverage;
  mutable std::shared_ptr<const CubeMap> tint;  ///< of the glass it shows (glass_tint.h); null: there is none
  std::size_t bytes() const {
    return radiance.bytes() + distance.bytes() + light.bytes() + relief.bytes() + coverage.bytes();
  }
};

/// A probe as draws see it. `maps` is null until the first capture is complete; it then gives nothing.
struct DrawnProbe {
  int index = 0;  ///< in the scene's list
  ProbeGeometry geometry;
  std::shared_ptr<const ProbeMaps> maps;
  /// What `auto` goes by; null: by what was measured elsewhere.
  std::shared_ptr<const TechniqueErrors> errors;
  bool open = false;               ///< the sky shows where the probe saw nothing, and there is such a place
  ShCoefficients openSky{};        ///< its diffuse light that comes in there, to be added to the maps'
  std::uint32_t shadowLights = 0;  ///< a bit for each light that asks for shadows and lies outside of its box
  bool imported = false;           ///< from a picture, which may have no coverage
};

enum class Lighting {
  Plain,   ///< VTK's own: no probe, no sky
  Unlit,   ///< KHR_materials_unlit: emission only
  Probes,  ///< probes, and the sky for what they leave
};

/// Which probes one actor uses: what its program is compiled for.
struct ProbeBinding {
  Lighting lighting = Lighting::Plain;
  std::vector<std::shared_ptr<const DrawnProbe>> probes;  ///< most important first, at most kMaxProbesPerDraw
  static constexpr std::size_t kMaxProbesPerDraw = 4;
  bool weights = true;        ///< false: one probe, at full weight all over the object
  bool sky = true;            ///< false: the probes leave nothing to it
  bool onlyProbes = false;    ///< what they leave to it goes to them, wherever one has weight
  std::vector<float> shares;  ///< of all of the object, in place of weights a pixel; empty: those
  float skyShare = 1.0f;      ///< beside `shares`
  /// Lights that a probe's coverage stands before, and those of them with maps of what moves; in the scene's order.
  std::vector<int> shadowLights, movingLights;
  std::size_t leftOut = 0;  ///< probes that reach the object and are more than a draw can have
  bool diffuse = true;      ///< false: the material is all metal

  /// What draws each: the probe's own technique, or what `auto` chose for this object. Empty: their own.
  std::vector<Technique> techniques;
  Technique technique(std::size_t slot) const;

  /// Equal keys share a program: techniques, importance groups, and what can be left out.
  std::string variantKey() const;
  /// The same by what stands in for its techniques while something moves; null if nothing does.
  std::shared_ptr<const ProbeBinding> standIn() const;
  /// Is a technique that is drawn one whose picture is a mean of frames, and of how many rays a pixel and frame? 0: no.
  int animatedSamples() const;
  /// Is what a technique samples here smoothed afterwards?
  bool blurred(std::size_t slot) const;
  /// Rays a pixel and frame of those that are; 0: none is.
  int blurredSamples() const;
  /// Is a box turned, or what a probe holds against its box?
  bool rotated() const;
  bool bevelled() const;
  bool occluded() const;
  /// Does the sky show through a probe? And lookup by lookup?
  bool open() const;
  bool openByLookup(std::size_t slot) const;
  /// Does a technique of a probe fetch from its distance cubemap?
  bool distances() const;
  /// Does a technique of a probe read the parameter, set to that choice?
  bool chooses(std::string_view parameter, std::string_view choice) const;
  /// Parameters that any of its techniques reads, each once.
  std::vector<const ParameterRow*> parameters() const;
  /// Group of equal importance of each probe, from 0.
  std::vector<int> groups() const;
};

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
