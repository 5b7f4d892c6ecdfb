// The types of refraction.glsl. Frames: positions share one origin and unit, directions are unit, axes are the same
// within a call.

// How the host identifies an object's shell: its surface as seen from a point inside.
#ifndef GLASS_SHELL
#define GLASS_SHELL samplerCube
#endif

struct GlassObject
{
  float ior;        // of the inside over that of the outside, > 0
  int form;  // 1: refracted once, 2: the same with back faces first, 3: followed through the shell
  bool sheet;  // no refraction: both of its faces are met at once
  float thickness;  // for forms 1 and 2: length of the way inside; 0: no absorption
  vec3 center;      // of the shell
  float radius;  // of a sphere around the object
};

// The ray along which light leaves the object, or is reflected, towards the eye.
struct GlassRay
{
  vec3 position;
  vec3 direction;  // from there, away from the eye
  float distance;  // inside the object
  float alpha;  // GGX alpha of a mirror with the same scattering
  int mirrored;  // number of internal reflections
};

struct GlassView
{
  GlassRay through;
  GlassRay mirrored;  // the reflection inside the object (`followed`); else the surface's own, unused
  bool followed;
  float reflectance;  // Fresnel's, unpolarised; 1: total reflection
};
