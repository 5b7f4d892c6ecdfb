// Where a ray leaves a box whose edges are rounded. Total: finite input gives a finite distance between 0 and the sharp box's.
//
// The rounded box is the set of points no farther than r from an inner box b = h - r, so along the ray
//   g(t) = Σ max(|x_i| - b_i, 0)² - r²,  x = p + t l from the box's centre,
// is convex, not above 0 at the start and not below it where the sharp box is left. Between the places where an axis sets in it is a
// quadratic, whose root is taken exactly; a few such steps from the sharp box's exit land on the right piece. Each step works with
// offsets from the point reached so far and takes the root as -C / (B + sqrt(B² - A C)): nothing cancels, and A = 0 needs no guard.

// One step, in units of the box: from t to the root of the piece there; t itself once that lies on the surface.
float roundedBoxStep(vec3 p, vec3 direction, vec3 b, float r, float t, float tBox)
{
  vec3 x = p + t * direction;
  vec3 o = max(abs(x) - b, vec3(0.0f));
  vec3 v = vec3(o.x > 0.0f ? (x.x < 0.0f ? -direction.x : direction.x) : 0.0f,
                o.y > 0.0f ? (x.y < 0.0f ? -direction.y : direction.y) : 0.0f,
                o.z > 0.0f ? (x.z < 0.0f ? -direction.z : direction.z) : 0.0f);
  float quadratic = dot(v, v);
  float linear = dot(v, o);
  float distance = length(o);
  // On the surface to the rounding of x, which is of size 1: a ray that slides along it must not be thrown off by that.
  if (abs(distance - r) < 1.5e-7f) { return t; }
  float constant = (distance - r) * (distance + r);
  float root = sqrt(max(linear * linear - quadratic * constant, 0.0f));
  float divisor = linear + root;
  if (!(divisor > 1.0e-12f)) { return t; }
  return clamp(t - constant / divisor, 0.0f, tBox);
}

// `exit`: distance to the sharp box's exit (slab.glsl).
float roundedBoxExit(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax, float bevel, float exit)
{
  vec3 halfSize = 0.5f * boxMax - 0.5f * boxMin;
  float size = max(max(halfSize.x, halfSize.y), halfSize.z);
  // A box that is a point, or a ray that goes nowhere.
  if (!(size > 1.0e-30f) || !(exit < 1.0e9f * size)) { return exit; }
  // In units of the box: no square under- or overflows.
  vec3 h = halfSize / size;
  vec3 low = position - boxMin;
  vec3 high = boxMax - position;
  vec3 gap = max(min(low, high), vec3(0.0f)) / size;
  // The start stays inside: within two faces' gaps the edge is sharper.
  float least = min(min(gap.x, gap.y), gap.z);
  float middle = max(min(gap.x, gap.y), min(max(gap.x, gap.y), gap.z));
  float r = min(min(max(bevel, 0.0f) / size, least + middle), min(min(h.x, h.y), h.z));
  if (!(r > 1.0e-7f)) { return exit; }

  vec3 p = (0.5f * low - 0.5f * high) / size;
  vec3 b = h - vec3(r);
  float tBox = exit / size;
  float t = tBox;
  // No loop: llvmpipe's compiler needs time exponential in a program's loops, and a technique may project many rays.
  t = roundedBoxStep(p, direction, b, r, t, tBox);
  t = roundedBoxStep(p, direction, b, r, t, tBox);
  t = roundedBoxStep(p, direction, b, r, t, tBox);
  t = roundedBoxStep(p, direction, b, r, t, tBox);
  t = roundedBoxStep(p, direction, b, r, t, tBox);
  return min(t * size, exit);
}
