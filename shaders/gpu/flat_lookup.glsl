// A prefiltered map looked up in its flat picture (filters/math/cube/flat_cube.h) in place of the cubemap: the same value, in two
// thirds of the time on llvmpipe. `size`: texels along a face of level 0, a power of two.
vec4 bpFlatLookup(sampler2D map, vec3 direction, float level, float size, float maxLevel)
{
  vec3 a = abs(direction);
  bool alongX = a.x >= a.y && a.x >= a.z;
  bool alongY = !alongX && a.y >= a.z;
  float largest = max(max(a.x, a.y), a.z);
  float s = alongX ? (direction.x < 0.0f ? direction.z : -direction.z) : (!alongY && direction.z < 0.0f ? -direction.x : direction.x);
  float t = alongY ? (direction.y < 0.0f ? -direction.z : direction.z) : -direction.y;
  float along = alongX ? direction.x : (alongY ? direction.y : direction.z);
  float face = (alongX ? 0.0f : (alongY ? 2.0f : 4.0f)) + (along < 0.0f ? 1.0f : 0.0f);
  vec2 st = vec2(s, t) * (0.5f / largest) + 0.5f;

  float l = clamp(level, 0.0f, maxLevel);
  float lower = floor(l);
  float fraction = l - lower;
  float own = float(int(size) >> int(lower));
  // Rows above level l: size + 2, size / 2 + 2, ...
  float row = 2.0f * (size - own) + 2.0f * lower;
  float rows = 2.0f * size - size * exp2(-maxLevel) + 2.0f * (maxLevel + 1.0f);
  vec2 texel = 1.0f / vec2(6.0f * (size + 2.0f), rows);
  vec2 place = vec2(face * (own + 2.0f), row) + 1.0f + st * own;
  vec4 finer = textureLod(map, place * texel, 0.0f);
  vec2 next = vec2(face * (0.5f * own + 2.0f), row + own + 2.0f) + 1.0f + st * (0.5f * own);
  return mix(finer, textureLod(map, next * texel, 0.0f), fraction);
}
