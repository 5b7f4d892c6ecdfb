// The plane of a polygon with these three corners: (n, d) such that dot(n, position) + d is the height above it, positive where `c` is
// seen to be counterclockwise of `a` and `b`. The unit of heights is the least that counts, 1e-5 of the lamp's size, above rounding.
vec4 lampPlaneThrough(vec3 a, vec3 b, vec3 c)
{
  vec3 along = b - a;
  float unit = 1.0f / max(length(along), 1.0e-30f);  // the first side counts as 1: products stay within a float's range
  along = unit * along;
  vec3 up = unit * (c - a);
  vec3 n = cross(along, up);
  n = n * (unit / max(1.0e-5f * length(n) * (1.0f + length(up)), 1.0e-30f));
  return vec4(n, -dot(n, a));
}
