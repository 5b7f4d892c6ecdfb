// What stands between broken input and the techniques: positions, normals and views come out of vertices, normal maps and
// interpolation, where NaN, infinity and vectors without length happen; one such pixel becomes a black square after bloom. Both
// hosts pass a pixel through here once, before any technique, so that techniques may rely on finite input; and every lookup's
// direction once. Uniforms (boxes, levels, parameters) are checked when a scene is read. Knows no technique.
//
// All tests are written so that NaN fails them: a comparison with NaN is false, min and max with NaN are anybody's guess.

// `v` unless a component is NaN or infinite. The sum finds either in one comparison.
vec3 finiteOr(vec3 v, vec3 instead)
{
  return abs(v.x) + abs(v.y) + abs(v.z) < 3.0e38f ? v : instead;
}

// The same for what has to have a direction. 1e-18: the least length whose square is no denormal number (1.2e-38), so that lengths
// and cosines can be formed of it; unit vectors are far from it.
vec3 directionOr(vec3 v, vec3 instead)
{
  float size = abs(v.x) + abs(v.y) + abs(v.z);
  return size > 1.0e-18f && size < 3.0e38f ? v : instead;
}

// Roughness in [0, 1]. One that is NaN counts as 1: a blurred pixel is not noticed, a glittering one is.
float roughnessWithin(float roughness)
{
  return roughness < 1.0f ? max(roughness, 0.0f) : 1.0f;
}

// reflect(-V, N), and for a normal that faces away from the eye (interpolated normals, normal maps) the limit of that where N.V
// is 0, straight on past the surface: mirrored in such a normal the ray would start below the surface and show what lies behind it.
vec3 reflectedView(vec3 normal, vec3 view)
{
  return 2.0f * max(dot(normal, view), 0.0f) * normal - view;
}

// What a cubemap is looked up with: any length but none. A hit at the capture origin itself (P and C in the same wall, R leading
// out of it) has no direction; the hardware would divide 0 by 0.
vec3 lookupDirection(vec3 direction)
{
  float size = abs(direction.x) + abs(direction.y) + abs(direction.z);
  return size > 1.0e-37f && size < 3.0e38f ? direction : vec3(0.0f, 0.0f, 1.0f);
}
