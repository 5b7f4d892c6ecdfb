// The complete calculation of one pixel, as the explain card shows it and `boxprobe explain` prints it. Frames are in
// the names; lengths in scene units, colours linear, before exposure.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"
#include "filters/core/surface/lit_point.h"
#include "filters/core/surface/surface_point.h"
#include "filters/explain/diffuse_explanation.h"
#include "filters/explain/glass_explanation.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// One lookup of a probe's map.
struct Lookup {
  glm::vec3 direction{0.0f};  ///< probe frame, as passed to the map; not normalised
  float level = 0.0f;
  float roughness = 0.0f;  ///< the roughness that the level was filtered for
  float weight = 0.0f;     ///< share of the technique's value
  glm::vec3 value{0.0f};   ///< the result
  float coverage = 1.0f;   ///< its alpha
  std::vector<TexelShare> texels;
};

struct ProbeExplanation : ProbeAtPoint {
  std::string name;
  std::string technique;   ///< full id
  float influence = 0.0f;  ///< weight in the influence box, before sharing
  glm::dvec3 originWorld{0.0};
  glm::dvec3 hitWorld{0.0};              ///< H; undefined if hitDistance is empty
  glm::vec3 reflectionProbe{0.0f};       ///< R in the probe's axes
  std::optional<glm::vec3> slabFactors;  ///< only techniques with a box
  std::optional<float> hitDistance;      ///< d, if the technique has a proxy
  std::optional<float> boxDistance;      ///< distance to the box, if the technique has refined it to a different d
  int distanceLookups = 0;               ///< fetches from the probe's distance cubemap
  glm::vec3 lookupDirection{0.0f};       ///< H - C, or what the technique samples instead, probe frame
  int face = -1;                         ///< 0..5 -x +x -y +y -z +z of the box
  float maxLevel = 0.0f;                 ///< last level of its chain
  std::optional<float> trueDistance;     ///< along R to the surface in the probe's distance cubemap
  float bevel = 0.0f;                    ///< radius of the box's edges here, scene units; 0: sharp
  std::optional<float> occlusion;        ///< factor of `specular` by hit distance, if the probe has one
  glm::vec3 specular{0.0f};              ///< result of the technique, before weight, intensity and occlusion
  glm::vec3 irradiance{0.0f};            ///< over pi, before weight and intensity
  DiffuseExplanation diffuse;            ///< its components
  /// Reflected light of its lamps as shapes, before weight and intensity: F0 times the first plus F90 times the second.
  glm::vec3 lampsF0{0.0f}, lampsF90{0.0f};
  float lampsInMap = 0.0f;  ///< the lamps' part of its map, mean of the colours, in addition to `specular`
  /// Of a probe through which the sky shows: the coverage of its lookups, and the sky along R at the surface's own
  /// level, which shows for the rest.
  std::optional<float> coverage;
  glm::vec3 openSky{0.0f};
  float openSkyLevel = 0.0f;
  int openLookups = 0;        ///< lookups of the sky for that
  bool openByLookup = false;  ///< the mean of the sky in each lookup's direction; the level is the last one's
  std::vector<Lookup> lookups;
};

/// The contribution of a planar mirror: moving objects, from a separate picture.
struct MirrorExplanation {
  glm::vec3 light{0.0f};     ///< premultiplied by the coverage
  float coverage = 0.0f;     ///< share of the lobe that they cover
  float share = 1.0f;        ///< factor of the light, the same as of the probes' reflection
  float hitDistance = 0.0f;  ///< along R to the object; undefined without coverage
  float level = 0.0f;        ///< whose texels are as large as the lobe
  int fetches = 0;
};

/// The transmittance of one probe for a light outside its box.
struct ProbeShadow {
  std::string name;
  float distance = 0.0f;  ///< from the surface to where the way to the light leaves the box, scene units
  glm::dvec3 hitWorld{0.0};
  float level = 0.0f;  ///< in the chain of transmittances
  glm::vec3 through{0.0f};
};
/// What blocks the way from one light to the surface.
struct LightShadow {
  int light = 0;  ///< in the scene's list
  glm::vec3 toLight{0.0f};
  bool facesAway = false;           ///< the surface faces away: no light, no lookup
  std::vector<ProbeShadow> probes;  ///< those whose coverage shadows the light
  std::optional<float> moving;      ///< factor from a map of moving objects, if the light has one
  glm::vec3 through{0.0f};          ///< total transmittance, weighted by the probes' shares
};

struct Explanation {
  int x = 0, y = 0;  ///< pixel, from the top left
  bool hit = false;  ///< false: the pixel shows the background; only `color` and `notes` are meaningful
  SurfacePoint surface;
  glm::vec3 lookupNormal{0.0f};  ///< the shading normal; of a brushed surface, the bent normal of its streak
  glm::vec3 reflectionWorld{0.0f};
  float nDotV = 0.0f;
  glm::vec3 f0{0.0f};
  glm::vec2 brdf{0.0f};    ///< split-sum factors of F0 and F90
  glm::vec3 direct{0.0f};  ///< light sources, both lobes
  glm::vec3 emissive{0.0f};
  /// Over pi, of probes, lamps and sky around the normal; empty: the material is all metal, or unlit.
  std::optional<glm::vec3> irradiance;
  /// The same by a path tracer, its squared standard error in w; empty: not traced.
  std::optional<glm::vec4> tracedIrradiance;
  glm::vec3 diffuse{0.0f};         ///< of probes and sky, with albedo
  glm::vec3 sheen{0.0f};           ///< of sheen, from the same irradiance; 0 without sheen
  glm::vec3 specularFactor{0.0f};  ///< of light from probes and sky: split sum, occlusion, the coat's transmittance
  glm::vec3 specular{0.0f};        ///< of probes and sky, with that factor
  std::optional<GlassExplanation> glass;  ///< of a material that transmits light; included in `color`
  glm::vec3 coat{0.0f};                   ///< contribution of a clear coat; 0 without one
  int lookupCount = 0;                    ///< all cubemap lookups, including coat and sky
  float skyWeight = 0.0f;
  float skyLevel = 0.0f;
  glm::vec3 skyValue{0.0f};
  std::optional<MirrorExplanation> mirror;  ///< empty: no mirror, or none with a picture here
  std::vector<ProbeExplanation> probes;     ///< in the order of the draw, most important first
  std::vector<LightShadow> shadows;         ///< of lights that request them
  glm::vec3 color{0.0f};                    ///< as computed here
  std::optional<glm::vec3> rendered;        ///< as drawn by the GPU
  /// Index in `probes` of the one with the largest share of the pixel, which views show. -1: none.
  int dominant = -1;
  float brightestTexel = 0.0f;  ///< largest component of any texel sampled
  /// Undefined and unusual conditions: one sentence each ("The capture origin lies outside the box, ...").
  std::vector<Phrase> notes;
};

/// The part of it from which references start.
LitPoint litPoint(const Explanation& explanation);

}  // namespace boxprobe
