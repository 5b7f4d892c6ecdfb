// Footprints: how large a patch of the captured cube a piece of a lobe covers. A piece of solid angle w leaves P, meets the wall at
// distance t and covers there a patch that, seen from the capture origin C, subtends J w,
//   J = (t / |d|)² cos_C / cos_P,   d from C to the hit, cosines between the wall's normal and the directions from C and from P.
// That, and not the distance alone, says which level holds the patch's mean. Needs slab.glsl, roughness.glsl and lobe_frame.glsl; the host supplies PROBE_MAP, fetchProbe and projectRay.

float footprintScale(ProbeShape probe, ProbeHit hit, vec3 direction)
{
  if (hit.distance >= kNoHit) { return 1.0f; }  // nothing to hit: seen from C as from P
  vec3 a = abs(hit.direction);
  float largest = max(max(a.x, a.y), a.z);
  // In units of t: no square under- or overflows. At the wall itself (t = 0) the patch is a point; the least t keeps 1 / t finite.
  float t = max(hit.distance, max(1.0e-9f * largest, 1.0e-37f));
  vec3 d = hit.direction / t;
  float distanceC = 0.0f;  // of C from the wall's plane, in units of t; over |d| it is cos_C
  float cosineP = 1.0f;
  if (hit.face >= 0)
  {
    // A soft choice of wall, by how nearly the ray meets each: a hard one draws lines along the edges.
    vec3 f = hit.slabFactors;
    vec3 w = vec3(f.x > t ? t / f.x : 1.0f, f.y > t ? t / f.y : 1.0f, f.z > t ? t / f.z : 1.0f);
    w = w * w;
    w = w * w;
    vec3 plane = vec3(direction.x < 0.0f ? -probe.boxMin.x : probe.boxMax.x,
                      direction.y < 0.0f ? -probe.boxMin.y : probe.boxMax.y,
                      direction.z < 0.0f ? -probe.boxMin.z : probe.boxMax.z);
    distanceC = dot(w, min(plane / t, vec3(1.0e9f)));
    cosineP = dot(w, abs(direction));
  }
  else
  {
    vec3 outwards = d - (0.5f * probe.boxMin + 0.5f * probe.boxMax) / t;
    float size = max(length(outwards), 1.0e-9f);
    distanceC = dot(outwards, d) / size;
    cosineP = dot(outwards, direction) / size;
  }
  // C behind the wall (outside the box) sees nothing of it: 0, the capture's own sharpness. The bounds are far beyond what a
  // level can express.
  float lengthD = max(length(d), 1.0e-4f);
  float cosineRatio = max(distanceC, 0.0f) / (lengthD * max(cosineP, 1.0e-3f));
  return min(cosineRatio / (lengthD * lengthD), 1.0e9f);
}

// Level for a footprint as large as a lobe of `alphaSquared`, and by `bias` levels sharper (below 0) or blurrier.
float footprintLevel(ProbeShape probe, float alphaSquared, float bias)
{
  return clamp(levelForAlpha(sqrt(clamp(alphaSquared, 0.0f, 1.0f)), probe.maxLevel) + bias, 0.0f, probe.maxLevel);
}

// The lobe as one piece, along its mean direction, which for rough surfaces leans towards the normal by `tilt`. `size`: alpha² of
// the piece.
vec4 footprintMean(PROBE_MAP map, ProbeShape probe, ShadingPoint point, float tilt, float size, float bias)
{
  float nv = clamp(dot(point.normal, point.view), 0.0f, 1.0f);
  vec3 l = normalize(point.normal * (2.0f * nv + tilt) - point.view);
  ProbeHit hit = projectRay(probe, point.position, point.normal, l);
  return fetchProbe(map, probe, hit.direction, footprintLevel(probe, size * footprintScale(probe, hit, l), bias));
}

// The lobe in pieces; see types.glsl.
FootprintLobe footprintLobe(ShadingPoint point, float points)
{
  FootprintLobe lobe;
  float p = clamp(point.roughness, 0.0f, 1.0f);
  float facing = dot(point.normal, point.view);
  float nv = clamp(facing, 1.0e-4f, 1.0f);
  vec3 side = point.view - point.normal * facing;
  float s = length(side);
  lobe.tangent = s > 1.0e-4f ? side / s : lobeTangent(point.normal);  // V along N: any tangent
  lobe.bitangent = cross(point.normal, lobe.tangent);
  lobe.normal = point.normal;
  lobe.alpha = p * p;
  lobe.view = vec3(sqrt(1.0f - nv * nv), 0.0f, nv);
  float a2 = lobe.alpha * lobe.alpha;
  lobe.maskView = sqrt(a2 + (1.0f - a2) * nv * nv);
  lobe.stretched = normalize(vec3(lobe.alpha * lobe.view.x, 0.0f, nv));
  lobe.size = 0.5f * (nv + lobe.maskView) * a2 / points;
  lobe.bias = 0.0f;
  lobe.scale = 1.0f;
  lobe.shift = 0.0f;
  return lobe;
}

FootprintSum footprintStart()
{
  FootprintSum sum;
  sum.value = vec4(0.0f);
  sum.weight = 0.0f;
  return sum;
}

FootprintSum footprintAdd(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum, float x,
                          float y, float weight)
{
  float a = lobe.alpha;
  float middle = 0.5f * (1.0f + lobe.stretched.z);
  float u = x * lobe.scale;
  float v = y * lobe.scale + lobe.shift;
  float t2 = (1.0f - middle) * sqrt(max(1.0f - u * u, 0.0f)) + middle * v;
  float t3 = sqrt(max(1.0f - u * u - t2 * t2, 0.0f));
  vec3 h = vec3(a * (lobe.stretched.x * t3 - lobe.stretched.z * t2), a * u,
                max(lobe.stretched.x * t2 + lobe.stretched.z * t3, 0.0f));
  float h2 = max(dot(h, h), 1.0e-18f);
  vec3 l = 2.0f * dot(lobe.view, h) / h2 * h - lobe.view;
  // Below the surface a piece has no light: next to no weight along the horizon, so that the weights never sum to 0.
  float lz = max(l.z, 1.0e-3f);
  vec3 direction = normalize(point.normal * lz + lobe.tangent * l.x + lobe.bitangent * l.y);
  float maskLight = sqrt(a * a + (1.0f - a * a) * lz * lz);
  float share = weight * lz * (lobe.view.z + lobe.maskView) / (lobe.view.z * maskLight + lz * lobe.maskView);  // G2 / G1

  ProbeHit hit = projectRay(probe, point.position, point.normal, direction);
  float size = lobe.size / (h2 * h2) * footprintScale(probe, hit, direction);
  FootprintSum result;
  result.value = sum.value + share * fetchProbe(map, probe, hit.direction, footprintLevel(probe, size, lobe.bias));
  result.weight = sum.weight + share;
  return result;
}

// Two points, mirrored in the plane of N and V.
FootprintSum footprintAddPair(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum, float x,
                              float y, float weight)
{
  FootprintSum one = footprintAdd(map, probe, point, lobe, sum, x, y, weight);
  return footprintAdd(map, probe, point, lobe, one, -x, y, weight);
}
