// Samples a prefiltered map from its flat picture (filters/math/cube/flat_cube.h) instead of the cubemap: the same
// value, in two thirds of the time on llvmpipe. `size`: texels along a face of level 0, a power of two.
vec4 bpFlatLookup(sampler2D map, vec3 direction, float level, float size, float maxLevel)
{
  vec3 a = abs(direction);
  bvec3 back = lessThan(direction, vec3(0.0f));
  bool alongX = a.x >= a.y && a.x >= a.z;
  bool alongY = !alongX && a.y >= a.z;
  float largest = max(max(a.x, a.y), a.z);
  float s = alongX ? (back.x ? direction.z : -direction.z) : (!alongY && back.z ? -direction.x : direction.x);
  float t = alongY ? (back.y ? -direction.z : direction.z) : -direction.y;
  float face = alongX ? (back.x ? 1.0f : 0.0f) : (alongY ? (back.y ? 3.0f : 2.0f) : (back.z ? 5.0f : 4.0f));
  vec2 st = vec2(s, t) * (0.5f / largest) + 0.5f;

  float l = clamp(level, 0.0f, maxLevel);
  float lower = floor(l);
  float own = float(int(size + 0.5f) >> int(lower));  // exp2 may return slightly less than a power of two
  float rows = 2.0f * size - size * exp2(-maxLevel) + 2.0f * (maxLevel + 1.0f);
  vec2 texel = 1.0f / vec2(6.0f * (size + 2.0f), rows);
  vec2 inner = vec2(face + st.x, st.y) * own;  // without borders; half of that in the next level
  // Rows above level l: size + 2, size / 2 + 2, ...
  vec2 border = vec2(2.0f * face, 2.0f * (size - own) + 2.0f * lower) + 1.0f;
  vec4 finer = textureLod(map, (inner + border) * texel, 0.0f);
  vec4 coarser = textureLod(map, (0.5f * inner + border + vec2(0.0f, own + 2.0f)) * texel, 0.0f);
  return mix(finer, coarser, l - lower);  // beyond the last level the weight is 0
}
