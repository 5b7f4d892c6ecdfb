// The values that refraction.glsl passes around. Frames: positions share one origin and unit, directions are unit, axes are the same
// for all of a call.

// What the host knows an object's shell by: where its surface lies, seen from a point within.
#ifndef GLASS_SHELL
#define GLASS_SHELL samplerCube
#endif

struct GlassObject
{
  float ior;        // of the inside over that of the outside, > 0
  int form;         // 1: bent once, 2: the same, back faces drawn first, 3: followed through the shell
  bool sheet;       // bends nothing: both of its faces are met at once
  float thickness;  // of forms 1 and 2: the way within; 0: nothing is absorbed
  vec3 center;      // of the shell
  float radius;     // no part of the object is farther from it
};

// Where light that reaches the eye came out of the object, or off it.
struct GlassRay
{
  vec3 position;
  vec3 direction;   // from there, away from the eye
  float distance;   // within the object
  float alpha;      // GGX alpha of a mirror that would scatter it as far
  int mirrored;     // times within the object
};

struct GlassView
{
  GlassRay through;
  GlassRay mirrored;  // of the mirrored view where it goes on within the object (`followed`); else the surface's own, unused
  bool followed;
  float reflectance;  // Fresnel's, unpolarised; 1: totally reflected, nothing passes
};
