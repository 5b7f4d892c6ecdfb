// Rays towards what is bright: directions drawn by the brightness of the probe's capture, as seen from the capture origin C, and
// their density as seen from the shading point P. For lamps too small for the lobe's own samples to find. Needs shared/cube.glsl and
// shared/slab.glsl; the host supplies, of a probe's light table (filters/math/cube/light_table.h), probeLightSize, the cells along a face, 0 without one, and
// fetchProbeLight; and mapFromProbe and probeFromMap, which turn directions between the probe's axes and its map's.

// Can rays be aimed at what the map shows in a direction from C? At walls of the box from anywhere in it if C is in it too, and at the
// infinitely far. `mirrored`: where R hits.
bool lightAimable(ProbeShape probe, ShadingPoint point, ProbeHit mirrored)
{
  if (mirrored.face < 0) { return mirrored.distance >= kNoHit && mirrored.direction == point.reflection; }
  vec3 size = probe.boxMax - probe.boxMin;
  vec3 outside = max(probe.boxMin - point.position, point.position - probe.boxMax) - 1.0e-4f * size;
  vec3 origin = max(probe.boxMin, -probe.boxMax);
  return max(max(outside.x, outside.y), outside.z) <= 0.0f && max(max(origin.x, origin.y), origin.z) < 0.0f;
}

// Of draws along the ray that made `hit`, per steradian as seen from P: their density at C times the solid angle there by that at P
// (footprint.glsl), of the wall alone that is hit. 0 for a hit that lies on no wall of the box, which draws do not reach.
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
    if (abs(at - wall) > 1.0e-5f * largest) { return 0.0f; }  // beyond the rounding of a hit, in units of its distance from C
    float ratio = min(hit.distance / (largest * lengthC), 1.0e6f);
    jacobian = ratio * ratio * (wall / (largest * lengthC)) / max(along, 1.0e-6f);
  }
  vec4 cell = fetchProbeLight(probe, cubeCell(mapFromProbe(probe, c), faceSize));
  return max(cell.z * lengthC * lengthC * lengthC * jacobian, 0.0f);
}

// A drawn direction from C, probe axes: `u` chooses the cell, `v` the place in it.
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

// Did the ray towards a drawn direction hit what was drawn, and not something in front of it?
bool lightReached(ProbeHit hit, vec3 fromC)
{
  vec3 a = abs(hit.direction);
  vec3 off = normalize(hit.direction / max(max(a.x, a.y), max(a.z, 1.0e-37f))) - normalize(fromC);
  return dot(off, off) < 1.0e-6f;  // a thousandth of a radian: far above rounding, far below a cell
}

// The direction from P towards what a draw points at: on the wall of the box, which holds C, or infinitely far away.
vec3 towardsLight(ProbeShape probe, vec3 position, vec3 fromC, bool far)
{
  if (far) { return normalize(fromC); }
  vec3 factors = slabFactors(vec3(0.0f), fromC, probe.boxMin, probe.boxMax);
  vec3 towards = min(min(factors.x, factors.y), factors.z) * fromC - position;
  vec3 a = abs(towards);
  return normalize(towards / max(max(a.x, a.y), max(a.z, 1.0e-37f)));
}
