// Footprints: how large a patch of the captured cube a lobe, or a part of it, covers. This, and not only the distance,
// determines the level with the patch's mean. There are two ways to find it.
//
// From one ray: a part of solid angle w leaves P, meets the wall at distance t and covers a patch that subtends J w
// from the capture origin C, J = (t / |d|)² cos_C / cos_P, with d from C to the hit and cosines between the wall's
// normal and the directions from C and from P. A level's lobe is round and the patch is elongated, so a round lobe of
// the same area misses more of it the longer it is. The longer axis, which grows with (t / |d|) / cos_P, therefore
// counts by half a power more than in the area, the power that the fit preferred.
//
// From several rays: the mean and the spread of their hits, seen from C. This also handles wide lobes that meet several
// walls, and the larger footprint of the lobe's nearer side. One lookup is then worth three rays; many parts are small
// enough for one each.
//
// Needs slab.glsl, roughness.glsl and lobe_frame.glsl; the host supplies PROBE_MAP, fetchProbe and projectRay. The
// constants in technique/evaluation_footprint*.glsl were found by tests/bench/fit_footprints.

// x: t / |d|, y: cos_C, z: cos_P; all 1 for a direction that meets nothing, which looks the same from C and P.
vec3 footprintCosines(ProbeShape probe, ProbeHit hit, vec3 direction)
{
  if (hit.distance >= kNoHit) { return vec3(1.0f); }
  vec3 a = abs(hit.direction);
  float largest = max(max(a.x, a.y), a.z);
  // In units of t, so that no square under- or overflows. At the wall itself (t = 0) the patch is a point; the minimum
  // keeps 1 / t finite.
  float t = max(hit.distance, max(1.0e-9f * largest, 1.0e-37f));
  float perT = 1.0f / t;  // one division; avoiding it would cost more
  vec3 d = hit.direction * perT;
  float distanceC = 0.0f;  // of C from the wall's plane, in units of t
  float cosineP = 1.0f;
  if (hit.face >= 0)
  {
    // A soft choice of wall by the similarity of distances: a hard choice would show lines along the edges.
    vec3 w = vec3(t) / max(hit.slabFactors, vec3(t));
    w = w * w;
    w = w * w;
    vec3 faces = vec3(direction.x < 0.0f ? -probe.boxMin.x : probe.boxMax.x,
                      direction.y < 0.0f ? -probe.boxMin.y : probe.boxMax.y,
                      direction.z < 0.0f ? -probe.boxMin.z : probe.boxMax.z);
    // A refined hit is not on the box: its planes are where the ray reaches each. For hits on the box this would
    // cancel.
    vec3 plane = faces;
    if (hit.refined > 0.5f)
    {
      plane = vec3(direction.x < 0.0f ? -hit.direction.x : hit.direction.x, direction.y < 0.0f ? -hit.direction.y : hit.direction.y,
                   direction.z < 0.0f ? -hit.direction.z : hit.direction.z) +
              (min(hit.slabFactors, vec3(1.0e30f)) - vec3(hit.distance)) * abs(direction);
    }
    distanceC = dot(w, min(plane * perT, vec3(1.0e9f)));
    cosineP = dot(w, abs(direction));
  }
  else
  {
    vec3 outwards = d - (0.5f * probe.boxMin + 0.5f * probe.boxMax) * perT;
    float size = max(length(outwards), 1.0e-9f);
    distanceC = dot(outwards, d) / size;
    cosineP = dot(outwards, direction) / size;
  }
  // C behind the wall (outside the box) sees nothing of it: 0, the capture's own sharpness. The bounds are far beyond
  // the range of levels.
  float ratio = 1.0f / max(length(d), 1.0e-4f);
  return vec3(ratio, min(max(distanceC, 0.0f) * ratio, 1.0e6f), max(cosineP, 1.0e-3f));
}

// J.
float footprintScale(ProbeShape probe, ProbeHit hit, vec3 direction)
{
  vec3 c = footprintCosines(probe, hit, direction);
  return c.x * c.x * c.y / c.z;
}

// Level of a footprint as large as a lobe of `alphaSquared`, made sharper (negative) or blurrier by `bias` levels.
float footprintLevel(ProbeShape probe, float alphaSquared, float bias)
{
  return clamp(levelForAlpha(sqrt(clamp(alphaSquared, 0.0f, 1.0f)), probe.maxLevel) + bias, 0.0f, probe.maxLevel);
}

// The same with a reduced bias below level 1 and none at level 0, so that mirrors stay sharp.
float footprintEasedLevel(ProbeShape probe, float alphaSquared, float bias)
{
  float level = footprintLevel(probe, alphaSquared, 0.0f);
  return clamp(level + bias * min(level, 1.0f), 0.0f, probe.maxLevel);
}

// The lobe divided into `points` parts of equal size, before a technique sets its constants; see types.glsl.
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
  lobe.scaleU = 1.0f;
  lobe.scaleV = 1.0f;
  lobe.shift = 0.0f;
  lobe.rise = 1.0f;
  return lobe;
}

// Schlick's reflectance of a microfacet at `cosine`, relative to grazing incidence; `f0`: that at normal incidence
// (ShadingPoint::f0). `rise`: a factor.
float facetReflectance(float f0, float cosine, float rise)
{
  float c = clamp(1.0f - cosine, 0.0f, 1.0f);
  float c2 = c * c;
  return f0 + (1.0f - f0) * rise * c2 * c2 * c;
}

// The ray of the point (u, v) of the disk (Heitz 2018).
FootprintRay footprintRay(ShadingPoint point, FootprintLobe lobe, float pointU, float pointV)
{
  float a = lobe.alpha;
  float middle = 0.5f * (1.0f + lobe.stretched.z);
  float u = pointU * lobe.scaleU;
  float v = pointV * lobe.scaleV + lobe.shift;
  float t2 = (1.0f - middle) * sqrt(max(1.0f - u * u, 0.0f)) + middle * v;
  float t3 = sqrt(max(1.0f - u * u - t2 * t2, 0.0f));
  vec3 h = vec3(a * (lobe.stretched.x * t3 - lobe.stretched.z * t2), a * u,
                max(lobe.stretched.x * t2 + lobe.stretched.z * t3, 0.0f));
  FootprintRay ray;
  ray.cover = 1.0f / max(dot(h, h), 1.0e-18f);
  vec3 l = 2.0f * dot(lobe.view, h) * ray.cover * h - lobe.view;
  // A part below the surface has no light: a tiny weight along the horizon keeps the sum of weights above 0. Only there
  // the direction is not of unit length.
  float lz = max(l.z, 1.0e-3f);
  vec3 upright = point.normal * lz + lobe.tangent * l.x;
  vec3 aside = lobe.bitangent * l.y;
  ray.direction = upright + aside;
  ray.mirrored = upright - aside;
  float maskLight = sqrt(a * a + (1.0f - a * a) * lz * lz);
  ray.share = facetReflectance(point.f0, dot(lobe.view, h) * sqrt(ray.cover), lobe.rise) * lz * (lobe.view.z + lobe.maskView) /
              (lobe.view.z * maskLight + lz * lobe.maskView);
  return ray;
}

FootprintSum footprintStart()
{
  FootprintSum sum;
  sum.value = vec4(0.0f);
  sum.weight = 0.0f;
  return sum;
}

// Adds the lookup of a part around one ray. `size`: fraction of the lobe's size.
FootprintSum footprintAddRay(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum,
                             FootprintRay ray, float weight, float size)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, ray.direction);
  vec3 c = footprintCosines(probe, hit, ray.direction);
  float along = c.x * ray.cover / c.z;  // the longer axis, in units of the part's width
  float area = lobe.size * size * along * c.x * c.y * ray.cover;
  FootprintSum result;
  float level = footprintEasedLevel(probe, area * sqrt(along), lobe.bias);
  result.value = sum.value + weight * ray.share * fetchProbe(map, probe, hit.direction, level);
  result.weight = sum.weight + weight * ray.share;
  return result;
}

FootprintSum footprintAdd(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum, float u,
                          float v, float weight, float size)
{
  return footprintAddRay(map, probe, point, lobe, sum, footprintRay(point, lobe, u, v), weight, size);
}

// Adds two parts that mirror each other in the plane of N and V: one ray's arithmetic serves both.
FootprintSum footprintAddPair(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum, float u,
                              float v, float weight, float size)
{
  FootprintRay ray = footprintRay(point, lobe, u, v);
  FootprintSum one = footprintAddRay(map, probe, point, lobe, sum, ray, weight, size);
  ray.direction = ray.mirrored;
  return footprintAddRay(map, probe, point, lobe, one, ray, weight, size);
}

// A ray's hit, seen from C.
vec3 footprintSeen(ProbeHit hit)
{
  vec3 a = abs(hit.direction);
  vec3 d = hit.direction / max(max(max(a.x, a.y), a.z), 1.0e-37f);  // avoids under- and overflow of squares
  return d / sqrt(max(dot(d, d), 1.0e-30f));
}

FootprintPatch footprintPatch(ProbeShape probe, ShadingPoint point, FootprintLobe lobe, float u, float v, float weight)
{
  FootprintRay ray = footprintRay(point, lobe, u, v);
  ProbeHit hit = projectRay(probe, point.position, point.normal, ray.direction);
  FootprintPatch seen;
  seen.first = footprintSeen(hit);
  seen.offset = vec3(0.0f);
  seen.squares = 0.0f;
  seen.weight = weight * ray.share;
  seen.alpha = hit.distance >= kNoHit ? lobe.alpha : -1.0f;
  return seen;
}

FootprintPatch footprintExtend(ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintPatch seen, float u, float v,
                               float weight)
{
  FootprintRay ray = footprintRay(point, lobe, u, v);
  ProbeHit hit = projectRay(probe, point.position, point.normal, ray.direction);
  vec3 offset = footprintSeen(hit) - seen.first;  // differences first: the spread of a narrow lobe would cancel
  float w = weight * ray.share;
  FootprintPatch result;
  result.first = seen.first;
  result.offset = seen.offset + w * offset;
  result.squares = seen.squares + w * dot(offset, offset);
  result.weight = seen.weight + w;
  result.alpha = seen.alpha;
  return result;
}

// The patch's mean. Its alpha² is `narrow` times the rays' variance and, for wide patches, which curve around C, `wide`
// times its square more. Without a hit it is the surface's own.
vec4 footprintMean(PROBE_MAP map, ProbeShape probe, FootprintPatch seen, float narrow, float wide, float bias)
{
  vec3 mean = seen.offset / seen.weight;
  float variance = max(seen.squares / seen.weight - dot(mean, mean), 0.0f);
  float size = seen.alpha < 0.0f ? variance * (narrow + wide * variance) : seen.alpha * seen.alpha;
  return fetchProbe(map, probe, seen.first + mean, footprintEasedLevel(probe, size, bias));
}
