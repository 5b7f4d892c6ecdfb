// Sphere proxy: the ray's exit from the sphere that encloses the box. Right for domes, bends straight walls.
//
// With o = P - centre: |o + t R|² = r² has the exit root t = -b + sqrt(b² - c), b = o.R, c = |o|² - r² <= 0 inside. For
// b > 0 the two terms cancel, so that root is taken as -c / (b + sqrt(..)). Lengths are divided by r first: no square
// under- or overflows. A start outside the sphere that misses it is given the closest point (root of 0), never a NaN.
ProbeHit projectSphere(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  vec3 centre = 0.5f * probe.boxMin + 0.5f * probe.boxMax;
  vec3 halfSize = 0.5f * probe.boxMax - 0.5f * probe.boxMin;
  float largest = max(max(halfSize.x, halfSize.y), max(halfSize.z, 1.0e-37f));
  vec3 off = position - centre;
  vec3 a = abs(off);
  // A box that is a point has a sphere of no radius: a billionth of the distance to it stands in, so that nothing is
  // divided by 0 and no square overflows.
  float radius = max(largest * length(halfSize / largest), max(1.0e-9f * max(max(a.x, a.y), a.z), 1.0e-37f));

  vec3 o = off / radius;
  float b = dot(o, reflection);
  float c = dot(o, o) - 1.0f;
  float root = sqrt(max(b * b - c, 0.0f));
  float t = b > 0.0f ? -c / (b + root) : root - b;
  t = max(t, 0.0f) * radius;

  ProbeHit hit;
  hit.distance = t;
  hit.direction = position + t * reflection;
  hit.face = -1;
  hit.slabFactors = vec3(kNoHit);
  return hit;
}
