// Sanitizes the input of techniques: positions, normals and views come from vertices, normal maps and interpolation,
// and may be NaN, infinite or zero vectors; one such pixel becomes a black square after bloom. Both hosts pass each
// pixel through here once, before any technique, and the direction of every lookup once. Uniforms (boxes, levels,
// parameters) are validated when a scene is read.
//
// All tests are written so that NaN fails them: a comparison with NaN is false; min and max with NaN are undefined.

// `v` unless a component is NaN or infinite. The sum detects both in one comparison.
vec3 finiteOr(vec3 v, vec3 instead)
{
  return abs(v.x) + abs(v.y) + abs(v.z) < 3.0e38f ? v : instead;
}

// The same for vectors that need a direction. 1e-18: the smallest length whose square is not denormal (1.2e-38), so
// that lengths and cosines can be computed; unit vectors are far from it.
vec3 directionOr(vec3 v, vec3 instead)
{
  float size = abs(v.x) + abs(v.y) + abs(v.z);
  return size > 1.0e-18f && size < 3.0e38f ? v : instead;
}

// Roughness in [0, 1]. NaN becomes 1: a blurred pixel is less visible than a glittering one.
float roughnessWithin(float roughness)
{
  return roughness < 1.0f ? max(roughness, 0.0f) : 1.0f;
}

// reflect(-V, N). For a normal that faces away from the eye (interpolated normals, normal maps) the limit for N.V = 0,
// straight past the surface: reflected at such a normal the ray would start below the surface and show what is behind
// it.
vec3 reflectedView(vec3 normal, vec3 view)
{
  return 2.0f * max(dot(normal, view), 0.0f) * normal - view;
}

// The direction of a cubemap lookup: any nonzero length. A hit at the capture origin itself (P and C in the same wall,
// R leading out of it) has no direction; the hardware would divide 0 by 0.
vec3 lookupDirection(vec3 direction)
{
  float size = abs(direction.x) + abs(direction.y) + abs(direction.z);
  return size > 1.0e-37f && size < 3.0e38f ? direction : vec3(0.0f, 0.0f, 1.0f);
}
