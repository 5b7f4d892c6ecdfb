// The values that the projection mathematics passes around. GLSL that is also C++ (through GLM); see filters/math.
//
// Frames. "Probe frame": axes of the probe's box, origin at its capture origin C, scene units. Working relative to C keeps
// full precision far from the world's origin: the subtraction P - C is done once, first.

// What a technique can be tuned by; the rows of filters/math/technique/parameter_table name, bound and explain each. Set are those that the
// technique at hand uses, no other.
struct TechniqueParameters
{
  int curve;              // row of the curves in level_curve.glsl
  float hardeningLength;  // scene units, > 0
  float power;            // > 0
  int fresnel;            // 0: (1 - N.V)^power, 1: the surface's own
  float samples;          // a whole number, >= 1
  float total;            // of all frames of a mean, a whole number; 0: of one
  int pattern;            // row of the choices of parameter `pattern`
  int levelOffset;        // 0 or 1
  int filtered;           // 0 or 1
  int sampling;           // 0: visible normals, 1: those and the probe's brightness, combined
  float steps;            // a whole number, >= 1
  float budget;           // the host's alone: it chooses the technique
};

// What the host knows a probe by where something has to be fetched from it: on the GPU its number among a draw's probes.
#ifndef PROBE_SLOT
#define PROBE_SLOT int
#endif

struct ProbeShape
{
  vec3 boxMin;      // projection box, probe frame; the capture origin may lie outside it
  vec3 boxMax;
  float maxLevel;   // last level of the prefiltered chain, the one baked for roughness 1
  int projection;   // row of the projection table
  float bevel;      // radius of the box's edges, scene units; 0: sharp
  PROBE_SLOT slot;
  TechniqueParameters parameters;
};

struct ProbeHit
{
  vec3 direction;   // what the cubemap is looked up with, probe frame, not normalised
  float distance;   // from P along R, scene units if R has unit length; a huge value if there is no proxy to hit
  int face;         // 0..5: -x +x -y +y -z +z of the box; -1 if the proxy is no box
  float refined;    // 1 where the hit is not on the proxy but on what the probe saw; slabFactors are then of a box through the hit
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
  int frame;        // of those that are averaged, from 0
  float fresnel;    // the surface's own reflectance at N.V, mean of its colours
  float f0;         // reflectance straight on over that at the edge (relativeF0 in fresnel.glsl); 1: the same from everywhere
};

// A lobe in pieces (footprint.glsl): half vectors seen from V, as points (u, v) of the unit disk that the visible normals fill evenly.
struct FootprintLobe
{
  vec3 tangent;    // of the normal, in the plane of N and V
  vec3 bitangent;
  vec3 normal;
  vec3 view;       // V in the frame tangent, bitangent, normal
  float alpha;
  float maskView;  // sqrt(alpha² + (1 - alpha²) NV²)
  vec3 stretched;  // V where the surface is stretched to roughness 1
  float size;      // alpha² of a piece whose half vector is the normal
  float bias;      // levels added to every piece's
  float scaleU;    // of the points
  float scaleV;
  float shift;     // of the points, along v
  float rise;      // of a piece's reflectance towards the edge, over a ray's
};

// A ray of a lobe.
struct FootprintRay
{
  vec3 direction;  // probe frame
  vec3 mirrored;   // that of the point (-u, v): on the other side of the plane of N and V
  float cover;     // 1 / the half vector's square before it is normalised; a piece covers its square of what it would along N
  float share;     // of the light: G2 / G1 times the facet's reflectance
};

// The lookups so far.
struct FootprintSum
{
  vec4 value;
  float weight;
};

// Rays that share one lookup: the directions of their hits, seen from C.
struct FootprintPatch
{
  vec3 first;
  vec3 offset;    // of the others from the first, and its square, weighted sums
  float squares;
  float weight;
  float alpha;    // of the surface where the first ray has nothing to hit; else negative
};

// A reflected ray (visible_normal.glsl).
struct LobeSample
{
  vec3 direction;    // unit, probe frame
  float weight;      // masking of the light over that of the view; 0: into the surface
  float solidAngle;  // it stands for where it is the only sample: 1 / density, steradian
};

// Where a pixel's samples lie (sample_pattern.glsl).
struct SamplePattern
{
  int pattern;
  uint first;   // number of the frame's first sample in the sequence
  uint step;    // 2^32 / samples
  uint shiftX;  // fractions of 2^32; of white noise a seed
  uint shiftY;
};
