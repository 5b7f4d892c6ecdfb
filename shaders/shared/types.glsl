// The types of the projection mathematics. GLSL that is also C++ (through GLM); see filters/math.
//
// Frames. "Probe frame": axes of the probe's box, origin at its capture origin C, scene units. Working relative to C
// keeps full precision far from the world's origin: the subtraction P - C is done once, first.

// The parameters of techniques; the rows of filters/math/technique/parameter_table name, bound and explain them. Only
// those that the current technique uses are set.
struct TechniqueParameters
{
  int curve;              // row of the curves in level_curve.glsl
  float hardeningLength;  // scene units, > 0
  float power;            // > 0
  int fresnel;            // 0: (1 - N.V)^power, 1: the surface's own
  float samples;  // an integer, >= 1
  float total;  // of all averaged frames, an integer; 0: of one frame
  int pattern;  // index of the choice of parameter `pattern`
  int levelOffset;        // 0 or 1
  int filtered;           // 0 or 1
  int sampling;  // 0: visible normals, 1: those combined with the probe's brightness
  float steps;  // an integer, >= 1
  float budget;  // used by the host only, to choose the technique
};

// How the host identifies a probe for fetches: on the GPU its index among a draw's probes.
#ifndef PROBE_SLOT
#define PROBE_SLOT int
#endif

struct ProbeShape
{
  vec3 boxMin;      // projection box, probe frame; the capture origin may lie outside it
  vec3 boxMax;
  float maxLevel;  // last level of the prefiltered chain, filtered for roughness 1
  int projection;   // row of the projection table
  float bevel;      // radius of the box's edges, scene units; 0: sharp
  PROBE_SLOT slot;
  TechniqueParameters parameters;
};

struct ProbeHit
{
  vec3 direction;  // direction of the cubemap lookup, probe frame, not normalised
  float distance;   // from P along R, scene units if R has unit length; a huge value if there is no proxy to hit
  int face;  // 0..5: -x +x -y +y -z +z of the box; -1 if the proxy is not a box
  float refined;  // 1 if the hit is on what the probe saw instead of the proxy; slabFactors are then those of a box through the hit
  vec3 slabFactors; // box only: distance along R to the exit plane of each axis; `distance` is the smallest. Of a hit that is not on the
                    // box (a rounded edge, a refined hit): of the box scaled about P until its face goes through the hit.
};

struct ShadingPoint
{
  vec3 position;    // P, probe frame
  vec3 normal;      // N, unit
  vec3 view;        // V, unit, towards the eye
  vec3 reflection;  // R, unit; see reflectedView in finite.glsl
  float roughness;  // perceptual
  ivec2 pixel;      // of the picture, from its lower left
  int frame;  // number among averaged frames, from 0
  float fresnel;  // the surface's reflectance at N.V, mean of its colours
  float f0;  // reflectance at normal relative to grazing incidence (relativeF0 in fresnel.glsl); 1: independent of the angle
};

// A lobe in parts (footprint.glsl): half vectors seen from V, as points (u, v) of the unit disk that the visible
// normals fill uniformly.
struct FootprintLobe
{
  vec3 tangent;    // of the normal, in the plane of N and V
  vec3 bitangent;
  vec3 normal;
  vec3 view;       // V in the frame tangent, bitangent, normal
  float alpha;
  float maskView;  // sqrt(alpha² + (1 - alpha²) NV²)
  vec3 stretched;  // V stretched to roughness 1
  float size;  // alpha² of a part whose half vector is the normal
  float bias;  // levels added to every part's
  float scaleU;    // of the points
  float scaleV;
  float shift;     // of the points, along v
  float rise;  // of a part's reflectance towards grazing angles, relative to a ray's
};

// A ray of a lobe.
struct FootprintRay
{
  vec3 direction;  // probe frame
  vec3 mirrored;  // that of the point (-u, v): mirrored in the plane of N and V
  float cover;  // 1 / the squared length of the unnormalised half vector; a part covers the square of this relative to one along N
  float share;     // of the light: G2 / G1 times the facet's reflectance
};

// The lookups so far.
struct FootprintSum
{
  vec4 value;
  float weight;
};

// Rays that share one lookup: the directions of their hits from C.
struct FootprintPatch
{
  vec3 first;
  vec3 offset;  // of the others from the first, and its square, weighted sums
  float squares;
  float weight;
  float alpha;  // of the surface if the first ray has no hit; else negative
};

// A reflected ray (visible_normal.glsl).
struct LobeSample
{
  vec3 direction;    // unit, probe frame
  float weight;  // masking of the light over that of the view; 0: below the surface
  float solidAngle;  // represented by it as the only sample: 1 / density, steradian
};

// The positions of a pixel's samples (sample_pattern.glsl).
struct SamplePattern
{
  int pattern;
  uint first;  // index of the frame's first sample in the sequence
  uint step;    // 2^32 / samples
  uint shiftX;  // fractions of 2^32; for white noise a seed
  uint shiftY;
};
