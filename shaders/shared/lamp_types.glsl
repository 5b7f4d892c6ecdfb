// What lamp.glsl and lamp_lobe.glsl pass around: lamps that shine evenly over a flat convex polygon.

// What the host knows a lamp by: on the GPU its number among a draw's lamps.
#ifndef LAMP_SLOT
#define LAMP_SLOT int
#endif

// Corners of a polygon at most.
const int kLampCorners = 8;

// Up to this roughness reflections show lamps in the map alone (lamp_fade.glsl).
const float kLampMapRoughness = 0.1f;

// A surface's lobe of visible normals, in the frame of its normal (z) and the view (y = 0).
struct LampLobe
{
  vec3 tangent;    // the frame's axes, where the lamps' corners are given
  vec3 bitangent;
  vec3 normal;
  vec3 view;       // unit, in the frame, above the surface
  float alpha;     // roughness squared
  float maskView;  // sqrt(alpha^2 + (1 - alpha^2) view.z^2)
  vec3 stretched;  // the view where the surface is stretched to roughness 1: the middle of the visible normals' cosine
  float spread;    // 0 to 1: weights over all of a lamp's image count, not those at its middle
};

// Masking and Fresnel's term where light comes from, (1 - s, s) times G2 / G1: F0 times x plus F90 times y is what a facet passes on of
// the light it is drawn for. s: Schlick's edge.
struct LampFacet
{
  vec3 normal;   // half vector, stretched, unit
  float cosine;  // of it with the stretched view: how densely the visible normals lie
  vec2 weight;
};

// The way around a polygon's image among the visible normals, so far.
struct LampImage
{
  LampFacet last;  // of the point reached last
  LampFacet pole;  // of the lamp's middle: triangles from here to each edge fill the image
  vec3 factor;     // sum over edges of the angle in turns times the unit normal: the vector form factor
  vec2 weight;     // sums over the triangles: of weights times light,
  float light;     // and of light
};

// A lamp's reflection by the image of its corners, and whether the lamp is too near for that.
struct LampGlance
{
  vec2 light;
  bool tooNear;
};
