// Sphere proxy: the ray's exit from the sphere that encloses the box. Right for domes, bends straight walls.
//
// With o = P - centre, all in units of the radius: along R the centre is nearest at t = -b, b = o.R, at the point f = o - b R, and the
// sphere is left sqrt(1 - |f|²) after that. From f, not from b² - (|o|² - 1): there the digits of a far start cancel. A start
// outside the sphere that misses it is given the closest point (root of 0), never a NaN.
ProbeHit projectSphere(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  vec3 centre = 0.5f * probe.boxMin + 0.5f * probe.boxMax;
  vec3 halfSize = 0.5f * probe.boxMax - 0.5f * probe.boxMin;
  float largest = max(max(halfSize.x, halfSize.y), max(halfSize.z, 1.0e-37f));
  vec3 off = position - centre;
  vec3 a = abs(off);
  // A box that is a point has a sphere of no radius: a billionth of a billionth of the distance to it stands in, the least at which
  // the square of o is still a float; nothing is divided by 0 and nothing overflows, however far the start.
  float radius = max(largest * length(halfSize / largest), max(1.0e-18f * max(max(a.x, a.y), a.z), 1.0e-37f));

  vec3 o = off / radius;
  float b = dot(o, reflection);
  vec3 f = o - b * reflection;
  float t = max(sqrt(max(1.0f - dot(f, f), 0.0f)) - b, 0.0f) * radius;

  ProbeHit hit;
  hit.distance = t;
  hit.direction = position + t * reflection;
  hit.face = -1;
  hit.refined = 0.0f;
  hit.slabFactors = vec3(kNoHit);
  return hit;
}
