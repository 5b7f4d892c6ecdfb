// Where a ray leaves a box whose edges are rounded. Total: finite input gives a finite distance between 0 and the sharp box's.
//
// The rounded box is the set of points no farther than r from an inner box b = h - r, so along the ray
//   g(t) = Σ max(|x_i| - b_i, 0)² - r²,  x = p + t l from the box's centre,
// is convex, not above 0 at the start and not below it where the sharp box is left. Between the places where an axis sets in it is a
// quadratic, whose root is taken exactly; a few such steps from the sharp box's exit land on the right piece. Nothing may cancel, or
// rays that run along a face leave anywhere:
//   x is known by its gaps from the faces, which near a face are exact to their own size; with the least gap's term written apart,
//     g = Σ' max(r - gap_i, 0)² - gap (2 r - gap)
//   each step works from the point reached so far and takes the root as -C / (B + sqrt(B² - A C)): A = 0 needs no guard.

// One step, in units of the box: from t to the root of the piece there. `low` and `high`: the start's gaps from the faces.
float roundedBoxStep(vec3 low, vec3 high, vec3 direction, float r, float t, float tBox)
{
  vec3 toLow = low + t * direction;
  vec3 toHigh = high - t * direction;
  vec3 g = max(min(toLow, toHigh), vec3(0.0f));
  vec3 o = max(vec3(r) - g, vec3(0.0f));
  vec3 v = vec3(o.x > 0.0f ? (toLow.x < toHigh.x ? -direction.x : direction.x) : 0.0f,
                o.y > 0.0f ? (toLow.y < toHigh.y ? -direction.y : direction.y) : 0.0f,
                o.z > 0.0f ? (toLow.z < toHigh.z ? -direction.z : direction.z) : 0.0f);
  float nearest = min(min(g.x, g.y), g.z);
  vec3 others = vec3(g.x == nearest ? 0.0f : o.x, g.x != nearest && g.y == nearest ? 0.0f : o.y,
                     g.x != nearest && g.y != nearest ? 0.0f : o.z);
  float quadratic = dot(v, v);
  float linear = dot(v, o);
  float constant = dot(others, others) - nearest * (2.0f * r - nearest);
  float divisor = linear + sqrt(max(linear * linear - quadratic * constant, 0.0f));
  // Nothing set in, or nowhere to go; else on from there.
  return divisor > 1.0e-12f ? clamp(t - constant / divisor, 0.0f, tBox) : t;
}

// `exit`: distance to the sharp box's exit (slab.glsl).
float roundedBoxExit(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax, float bevel, float exit)
{
  vec3 halfSize = 0.5f * boxMax - 0.5f * boxMin;
  float size = max(max(halfSize.x, halfSize.y), halfSize.z);
  // A box that is a point, or a ray that goes nowhere. 1e-37: the least size by which a float can be divided.
  if (!(size > 1.0e-37f) || !(exit < 1.0e9f * size)) { return exit; }
  // In units of the box: no square under- or overflows.
  vec3 low = (position - boxMin) / size;
  vec3 high = (boxMax - position) / size;
  vec3 gap = max(min(low, high), vec3(0.0f));
  // The start stays inside: within two faces' gaps the edge is sharper.
  float least = min(min(gap.x, gap.y), gap.z);
  float middle = max(min(gap.x, gap.y), min(max(gap.x, gap.y), gap.z));
  float r = min(min(max(bevel, 0.0f) / size, least + middle), min(min(halfSize.x, halfSize.y), halfSize.z) / size);
  if (!(r > 1.0e-7f)) { return exit; }

  float tBox = exit / size;
  float t = tBox;
  // No loop: llvmpipe's compiler needs time exponential in a program's loops, and a technique may project many rays.
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  return min(t * size, exit);
}
