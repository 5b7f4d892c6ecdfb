// The box's hit, refined against what the probe saw: its distance cubemap stands in for the scene (a distance impostor). For rooms
// that are not boxes. At most `steps` fetches, from the nearest texel:
//   1 at the box's hit: what the probe saw there may lie on the box (done), before it or behind it;
//   2 at seven tenths of the way: something may stand in between although the end of the ray is clear;
//   3 and more: secant steps.
// In p(t) = |X| / D - 1, X = P + t R - C and D the distance seen in that direction, a plane is a straight line: where two fetches see
// the same flat surface, the secant meets it exactly. The box's hit is kept where the probe saw nothing. What is hidden from the
// capture origin cannot be found. Needs technique/projection_box.glsl; the host supplies fetchProbeDistance.

// p(t): how far behind what the probe saw X lies, relative to its distance; below 0 in free space. kNoHit where nothing was seen.
float impostorDepth(ProbeShape probe, vec3 x)
{
  float seen = fetchProbeDistance(probe, x);
  // Compared before dividing: a quotient beyond any room's is only "far behind".
  float size = length(x);
  return seen > 0.0f ? (size < 1.0e6f * seen ? size / seen - 1.0f : 1.0e6f) : kNoHit;
}

// Where the ray meets the plane, parallel to the face it leaves the box by, through the point seen in the direction of x.
float impostorPlane(vec3 position, vec3 reflection, vec3 x, float depth, int face)
{
  vec3 seen = x / max(1.0f + depth, 1.0e-6f);
  float gap = face < 2 ? seen.x - position.x : (face < 4 ? seen.y - position.y : seen.z - position.z);
  float speed = face < 2 ? reflection.x : (face < 4 ? reflection.y : reflection.z);
  return abs(speed) > 1.0e-6f ? gap / speed : 0.0f;
}

// Where the line through two values of p crosses 0; `otherwise` if that is not between low and high.
float impostorSecant(float t0, float p0, float t1, float p1, float low, float high, float otherwise)
{
  float rise = p1 - p0;
  float t = abs(rise) > 1.0e-6f ? t1 - p1 * ((t1 - t0) / rise) : otherwise;
  return t > low && t < high ? t : otherwise;
}

ProbeHit projectImpostor(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  // Relative depth that still counts as on the surface: half a texel of a 256² face on a wall seen at 80 degrees.
  const float kOn = 0.02f;
  const float kFarthest = 100.0f; // times the box's distance
  const float kBetween = 0.7f;    // of the way to the box's hit
  ProbeHit hit = projectBox(probe, position, normal, reflection);
  float tBox = hit.distance;
  float steps = probe.parameters.steps;
  float pBox = impostorDepth(probe, hit.direction);
  bool onBox = abs(pBox) < kOn;
  if (pBox >= kNoHit || tBox > 1.0e30f || (onBox && steps < 2.0f)) { return hit; }

  // Between low and high lies the surface, as far as is known; `high` may be beyond the box.
  float low = 0.0f;
  float pLow = -1.0f;
  float high = tBox;
  float pHigh = pBox;
  if (steps >= 2.0f)
  {
    float t = kBetween * tBox;
    float p = impostorDepth(probe, position + t * reflection);
    if (p >= kNoHit) { p = -1.0f; }
    if (p > kOn)
    {
      high = t;
      pHigh = p;
      onBox = false;
    }
    else
    {
      low = t;
      pLow = p;
    }
  }
  if (onBox) { return hit; }

  float t = tBox;
  if (pHigh > 0.0f)
  {
    // In between: first by a plane along the box's face, then by secants.
    t = impostorPlane(position, reflection, position + high * reflection, pHigh, hit.face);
    if (!(t > low && t < high)) { t = impostorSecant(low, pLow, high, pHigh, low, high, 0.5f * (low + high)); }
    // No loops: llvmpipe's compiler needs time exponential in a program's loops, and a technique may project many rays.
    float p = steps > 2.0f ? impostorDepth(probe, position + t * reflection) : kNoHit;
    if (p < kNoHit)
    {
      float tNext = p > 0.0f ? impostorSecant(low, pLow, t, p, low, t, t) : impostorSecant(t, p, high, pHigh, t, high, t);
      if (p > 0.0f) { high = t; pHigh = p; } else { low = t; pLow = p; }
      t = tNext;
      p = steps > 3.0f ? impostorDepth(probe, position + t * reflection) : kNoHit;
      if (p < kNoHit)
      {
        t = p > 0.0f ? impostorSecant(low, pLow, t, p, low, t, t) : impostorSecant(t, p, high, pHigh, t, high, t);
      }
    }
  }
  else
  {
    // Behind the box.
    float tLast = tBox;
    float pLast = pBox;
    t = min(tBox / max(1.0f + pBox, 1.0e-6f), kFarthest * tBox);
    float p = steps > 2.0f ? impostorDepth(probe, position + t * reflection) : kNoHit;
    // What does not come nearer has met another surface: the first guess is the better one.
    if (p < kNoHit && abs(p) <= 0.5f * abs(pLast))
    {
      float tNext = impostorSecant(tLast, pLast, t, p, 0.3f * tBox, kFarthest * tBox, t);
      tLast = t;
      pLast = p;
      t = tNext;
      p = steps > 3.0f ? impostorDepth(probe, position + t * reflection) : kNoHit;
      if (p < kNoHit && abs(p) <= 0.5f * abs(pLast))
      {
        t = impostorSecant(tLast, pLast, t, p, 0.3f * tBox, kFarthest * tBox, t);
      }
    }
  }
  // The box scaled about P until its face goes through the hit: so evaluations have a wall's normal and distance to work with.
  hit.slabFactors = min(hit.slabFactors, vec3(1.0e30f)) * (tBox > 0.0f ? t / tBox : 1.0f);
  hit.refined = 1.0f;
  hit.distance = t;
  hit.direction = position + t * reflection;
  return hit;
}
