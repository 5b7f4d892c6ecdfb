// The whole calculation of one pixel as plain values: what the explain card shows and `boxprobe explain` prints. Frames
// are in the names; lengths in scene units, colours linear, before exposure.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/surface/lit_point.h"
#include "filters/core/surface/surface_point.h"
#include "filters/explain/diffuse_explanation.h"
#include "filters/explain/glass_explanation.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// One fetch from a probe's map.
struct Lookup {
  glm::vec3 direction{0.0f};  ///< probe frame, as handed to the map; not normalised
  float level = 0.0f;
  float roughness = 0.0f;  ///< what that level was baked for
  float weight = 0.0f;     ///< share of the technique's value
  glm::vec3 value{0.0f};   ///< what came back
  float coverage = 1.0f;   ///< its alpha
  std::vector<TexelShare> texels;
};

struct ProbeExplanation : ProbeAtPoint {
  std::string name;
  std::string technique;   ///< full id
  float influence = 0.0f;  ///< the influence box's own weight, before sharing
  glm::dvec3 originWorld{0.0};
  glm::dvec3 hitWorld{0.0};              ///< H; meaningless if hitDistance is empty
  glm::vec3 reflectionProbe{0.0f};       ///< R in the probe's axes
  std::optional<glm::vec3> slabFactors;  ///< techniques with a box only
  std::optional<float> hitDistance;      ///< d, if the technique has a proxy to hit
  std::optional<float> boxDistance;      ///< to the box, where the technique has refined it to another d
  int distanceLookups = 0;               ///< fetches from the probe's distance cubemap
  glm::vec3 lookupDirection{0.0f};       ///< H - C (or what the technique looks up in its place), probe frame
  int face = -1;                         ///< 0..5 -x +x -y +y -z +z of the box
  float maxLevel = 0.0f;                 ///< last level of its chain
  std::optional<float> trueDistance;     ///< along R to what the probe's distance cubemap holds there
  float bevel = 0.0f;                    ///< radius of the box's edges here, scene units; 0: sharp
  std::optional<float> occlusion;        ///< factor of `specular` by the hit's distance, if the probe has one
  glm::vec3 specular{0.0f};              ///< the technique's value, before weight, intensity and occlusion
  glm::vec3 irradiance{0.0f};            ///< over pi, before weight and intensity
  DiffuseExplanation diffuse;            ///< what that is made of
  /// Of its lamps as shapes, before weight and intensity: F0 times the one plus F90 times the other is reflected.
  glm::vec3 lampsF0{0.0f}, lampsF90{0.0f};
  float lampsInMap = 0.0f;  ///< what its map shows of them, mean of the colours, beside `specular`
  /// Of a probe that lets the sky through: how much of the lookups it covers, and the sky along R at the surface's own
  /// level, which shows for the rest.
  std::optional<float> coverage;
  glm::vec3 openSky{0.0f};
  float openSkyLevel = 0.0f;
  int openLookups = 0;        ///< of the sky, for that
  bool openByLookup = false;  ///< it is the mean of what each lookup looked out to; the level is that of the last
  std::vector<Lookup> lookups;
};

/// What a planar mirror adds: objects that move, from a picture of their own.
struct MirrorExplanation {
  glm::vec3 light{0.0f};     ///< premultiplied by the coverage
  float coverage = 0.0f;     ///< share of the lobe that they take
  float share = 1.0f;        ///< that the light is multiplied by, as what the probes reflect is
  float hitDistance = 0.0f;  ///< along R to what is met; meaningless without coverage
  float level = 0.0f;        ///< whose texels are as large as the lobe there
  int fetches = 0;
};

/// What one probe lets through of a light outside of its box.
struct ProbeShadow {
  std::string name;
  float distance = 0.0f;  ///< along the way to the light to where it leaves the box, scene units
  glm::dvec3 hitWorld{0.0};
  float level = 0.0f;  ///< of the chain of what the probe lets through
  glm::vec3 through{0.0f};
};
/// What stands between the surface and one light.
struct LightShadow {
  int light = 0;  ///< in the scene's list
  glm::vec3 toLight{0.0f};
  bool facesAway = false;           ///< the surface does: no light, no lookup
  std::vector<ProbeShadow> probes;  ///< those whose coverage stands before it
  std::optional<float> moving;      ///< factor of a map of what moves, if the light has one
  glm::vec3 through{0.0f};          ///< in all, by the probes' shares
};

struct Explanation {
  int x = 0, y = 0;  ///< pixel, from the top left
  bool hit = false;  ///< false: the pixel shows the background; only `color` and `notes` are meaningful
  SurfacePoint surface;
  glm::vec3 lookupNormal{0.0f};  ///< the shading normal; of a brushed surface, what stands for its streak
  glm::vec3 reflectionWorld{0.0f};
  float nDotV = 0.0f;
  glm::vec3 f0{0.0f};
  glm::vec2 brdf{0.0f};    ///< split-sum factors of F0 and F90
  glm::vec3 direct{0.0f};  ///< light sources, both lobes
  glm::vec3 emissive{0.0f};
  /// Over pi, of probes, lamps and sky around the normal; empty: the material is all metal, or unlit.
  std::optional<glm::vec3> irradiance;
  glm::vec3 diffuse{0.0f};         ///< of probes and sky, with albedo
  glm::vec3 sheen{0.0f};           ///< of cloth, of the same light; 0 without one
  glm::vec3 specularFactor{0.0f};  ///< of what probes and sky send: split sum, occlusion, what the coat lets through
  glm::vec3 specular{0.0f};        ///< of probes and sky, with that factor
  std::optional<GlassExplanation> glass;  ///< of a material that transmits light; its light is part of `color`
  glm::vec3 coat{0.0f};                   ///< what a clear coat adds; 0 without one
  int lookupCount = 0;                    ///< fetches from cubemaps in all, coat and sky included
  float skyWeight = 0.0f;
  float skyLevel = 0.0f;
  glm::vec3 skyValue{0.0f};
  std::optional<MirrorExplanation> mirror;  ///< empty: no mirror, or one without a picture here
  std::vector<ProbeExplanation> probes;     ///< in the order of the draw, most important first
  std::vector<LightShadow> shadows;         ///< of lights that ask for them
  glm::vec3 color{0.0f};                    ///< computed here
  std::optional<glm::vec3> rendered;        ///< the same pixel as the GPU drew it
  /// Position in `probes` of the one with the largest share of the pixel: the one that views show. -1: none.
  int dominant = -1;
  float brightestTexel = 0.0f;  ///< largest component of any texel fetched
  /// What is undefined and why, what is unusual: one sentence each ("The capture origin lies outside the box, ...").
  std::vector<std::string> notes;
};

/// What of it the references begin from.
LitPoint litPoint(const Explanation& explanation);

}  // namespace boxprobe
