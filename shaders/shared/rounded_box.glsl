// Exit of a ray from a box with rounded edges. Total: finite input gives a finite distance between 0 and the sharp
// box's.
//
// The rounded box is the set of points no farther than r from an inner box b = h - r, so along the ray g(t) = Σ
// max(|x_i| - b_i, 0)² - r², x = p + t l from the box's centre, is convex, not positive at the start and not negative
// at the sharp box's exit. Between the points where an axis becomes active it is a quadratic, whose root is taken
// exactly; a few such steps from the sharp box's exit reach the right piece. To avoid cancellation for rays along a
// face, x is given by its gaps from the faces, which are accurate near a face; with the smallest gap's term separate, g
// = Σ' max(r - gap_i, 0)² - gap (2 r - gap). Each step starts at the point reached so far and takes the root as -C / (B
// + sqrt(B² - A C)), where A = 0 needs no special case.

// One step, in units of the box: from t to the root of the current piece. `low` and `high`: the start's gaps from the
// faces.
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
  // No active axis, or no direction; else continues from there.
  return divisor > 1.0e-12f ? clamp(t - constant / divisor, 0.0f, tBox) : t;
}

// `exit`: distance to the sharp box's exit (slab.glsl).
float roundedBoxExit(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax, float bevel, float exit)
{
  vec3 halfSize = 0.5f * boxMax - 0.5f * boxMin;
  float size = max(max(halfSize.x, halfSize.y), halfSize.z);
  // A degenerate box, or a ray without direction. 1e-37: the smallest size by which a float can be divided.
  if (!(size > 1.0e-37f) || !(exit < 1.0e9f * size)) { return exit; }
  // In units of the box, so that no square under- or overflows.
  vec3 low = (position - boxMin) / size;
  vec3 high = (boxMax - position) / size;
  vec3 gap = max(min(low, high), vec3(0.0f));
  // The start stays inside: near two faces the edge is sharper.
  float least = min(min(gap.x, gap.y), gap.z);
  float middle = max(min(gap.x, gap.y), min(max(gap.x, gap.y), gap.z));
  float r = min(min(max(bevel, 0.0f) / size, least + middle), min(min(halfSize.x, halfSize.y), halfSize.z) / size);
  if (!(r > 1.0e-7f)) { return exit; }

  float tBox = exit / size;
  float t = tBox;
  // No loop: llvmpipe's compiler takes time exponential in the number of loops, and a technique may project many rays.
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  t = roundedBoxStep(low, high, direction, r, t, tBox);
  return min(t * size, exit);
}
