// Sampling of bright directions: drawn by the brightness of the probe's capture, as seen from the capture origin C,
// with their density as seen from the shading point P. For lamps that are too small for the lobe's own samples. Needs
// shared/cube.glsl and shared/slab.glsl; the host supplies, from a probe's light table
// (filters/math/cube/light_table.h), probeLightSize (cells along a face, 0 without a table) and fetchProbeLight; and
// mapFromProbe and probeFromMap, rotations between the probe's axes and its map's.

// Can rays be aimed at what the map shows in a direction from C? Yes for walls of the box from anywhere inside, if C is
// inside too, and for infinitely distant light. `mirrored`: the hit of R.
bool lightAimable(ProbeShape probe, ShadingPoint point, ProbeHit mirrored)
{
  if (mirrored.face < 0) { return mirrored.distance >= kNoHit && mirrored.direction == point.reflection; }
  vec3 size = probe.boxMax - probe.boxMin;
  vec3 outside = max(probe.boxMin - point.position, point.position - probe.boxMax) - 1.0e-4f * size;
  vec3 origin = max(probe.boxMin, -probe.boxMax);
  return max(max(outside.x, outside.y), outside.z) <= 0.0f && max(max(origin.x, origin.y), origin.z) < 0.0f;
}

// The density of draws along the ray that made `hit`, per steradian as seen from P: the density at C times the ratio of
// solid angles at C and P (footprint.glsl), for the wall that is hit. 0 for a hit that is not on a wall of the box,
// which draws do not reach.
float lightDensity(ProbeShape probe, ProbeHit hit, vec3 direction, int faceSize)
{
  vec3 a = abs(hit.direction);
  float largest = max(max(a.x, a.y), max(a.z, 1.0e-37f));
  vec3 c = hit.direction / largest;
  float lengthC = length(c);
  float jacobian = 1.0f;
  if (hit.face >= 0)
  {
    float wall = direction.x < 0.0f ? -probe.boxMin.x : probe.boxMax.x;
    float at = a.x;
    float along = abs(direction.x);
    if (hit.face / 2 == 1) { wall = direction.y < 0.0f ? -probe.boxMin.y : probe.boxMax.y; at = a.y; along = abs(direction.y); }
    if (hit.face / 2 == 2) { wall = direction.z < 0.0f ? -probe.boxMin.z : probe.boxMax.z; at = a.z; along = abs(direction.z); }
    if (abs(at - wall) > 1.0e-5f * largest) { return 0.0f; }  // beyond the rounding error of a hit, relative to its distance from C
    float ratio = min(hit.distance / (largest * lengthC), 1.0e6f);
    jacobian = ratio * ratio * (wall / (largest * lengthC)) / max(along, 1.0e-6f);
  }
  vec4 cell = fetchProbeLight(probe, cubeCell(mapFromProbe(probe, c), faceSize));
  return max(cell.z * lengthC * lengthC * lengthC * jacobian, 0.0f);
}

// A drawn direction from C, probe axes: `u` selects the cell, `v` the place in it.
vec3 lightDirection(ProbeShape probe, vec2 u, vec2 v, int faceSize)
{
  int count = 6 * faceSize * faceSize;
  int cell = min(int(u.y * float(count)), count - 1);
  vec4 entry = fetchProbeLight(probe, cell);
  if (u.x >= entry.x) { cell = int(entry.y); }
  int row = cell / faceSize;
  int face = row / faceSize;
  float s = 2.0f * (float(cell - row * faceSize) + v.x) / float(faceSize) - 1.0f;
  float t = 2.0f * (float(row - face * faceSize) + v.y) / float(faceSize) - 1.0f;
  return probeFromMap(probe, cubeDirection(face, s, t));
}

// Did the ray towards a drawn direction reach it, without meeting something in front?
bool lightReached(ProbeHit hit, vec3 fromC)
{
  vec3 a = abs(hit.direction);
  vec3 off = normalize(hit.direction / max(max(a.x, a.y), max(a.z, 1.0e-37f))) - normalize(fromC);
  return dot(off, off) < 1.0e-6f;  // a milliradian: far above rounding, far below a cell
}

// The direction from P to the target of a draw: on the wall of the box, which contains C, or infinitely far away.
vec3 towardsLight(ProbeShape probe, vec3 position, vec3 fromC, bool far)
{
  if (far) { return normalize(fromC); }
  vec3 factors = slabFactors(vec3(0.0f), fromC, probe.boxMin, probe.boxMax);
  vec3 towards = min(min(factors.x, factors.y), factors.z) * fromC - position;
  vec3 a = abs(towards);
  return normalize(towards / max(max(a.x, a.y), max(a.z, 1.0e-37f)));
}
