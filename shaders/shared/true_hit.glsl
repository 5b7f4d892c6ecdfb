// The true hit of a ray as far as the probe saw the scene: follows the ray through the probe's distance cubemap
// (distances from the capture origin, 0 where nothing was seen). For judging techniques, not for drawing: it takes
// dozens of fetches. Surfaces hidden from the origin are missed. Needs shared/cube.glsl; the host supplies DISTANCE_MAP
// and fetchDistance (the nearest texel, not interpolated).

// How far a point is behind what the probe saw in its direction; negative: in free space. Where nothing was seen space
// is free.
float trueHitDepth(DISTANCE_MAP map, ProbeShape probe, vec3 position)
{
  float seen = fetchDistance(map, probe, position);
  return seen > 0.0f ? length(position) - seen : -1.0f;
}

// A hit from one texel: distance along the ray to the plane through the texel and two of its neighbours.
struct TexelHit
{
  float distance; // along the ray
  bool onPlane;  // the plane is met within the texel: exact for a flat wall
  bool start;  // the plane from which the ray starts: no hit
};

TexelHit texelHit(DISTANCE_MAP map, ProbeShape probe, float faceSize, vec3 position, vec3 reflection, float near)
{
  TexelHit result;
  result.distance = near;
  result.onPlane = false;
  result.start = false;
  vec3 c = cubeTexelCentre(position + near * reflection, faceSize);
  float step = 2.0f / faceSize;
  vec3 side = vec3(c.x > 0.0f ? -step : step, c.y > 0.0f ? -step : step, c.z > 0.0f ? -step : step);
  vec3 c1 = c;
  vec3 c2 = c;
  if (abs(c.x) == 1.0f) { c1.y = c.y + side.y; c2.z = c.z + side.z; }
  else if (abs(c.y) == 1.0f) { c1.z = c.z + side.z; c2.x = c.x + side.x; }
  else { c1.x = c.x + side.x; c2.y = c.y + side.y; }
  float d0 = fetchDistance(map, probe, c);
  float d1 = fetchDistance(map, probe, c1);
  float d2 = fetchDistance(map, probe, c2);
  if (d1 <= 0.0f || d2 <= 0.0f) { return result; }

  vec3 q = c * (d0 / length(c));
  vec3 n = cross(c1 * (d1 / length(c1)) - q, c2 * (d2 / length(c2)) - q);
  float size = length(n);
  float gap = dot(n, q - position);
  result.start = abs(gap) < 2.0e-3f * d0 * size;
  float along = dot(n, reflection);
  float t = abs(along) > 1.0e-6f * size ? gap / along : -1.0f;
  vec3 hit = position + t * reflection;
  vec3 a = abs(hit);
  vec3 off = hit / max(max(a.x, a.y), max(a.z, 1.0e-37f)) - c;
  // A plane through texels of two surfaces meets the ray elsewhere: then the texel itself is used.
  result.onPlane = t > 0.0f && max(max(abs(off.x), abs(off.y)), abs(off.z)) < 1.5f * step;
  if (result.onPlane) { result.distance = t; }
  return result;
}

// Distance along the unit vector `reflection` from `position` (probe frame) to the first surface; kNoHit if there is
// none within `reach`. On a plane, away from its silhouette, exact up to rounding for any face size.
float trueHitDistance(DISTANCE_MAP map, ProbeShape probe, float faceSize, vec3 position, vec3 reflection, float reach)
{
  const int kSteps = 64;
  const int kHalvings = 12;
  const float kThick = 1.0f;  // texels: how far behind a curved surface its own shape explains
  bool inFront = false;
  float before = 0.0f;
  for (int i = 1; i <= kSteps; ++i)
  {
    float t = reach * float(i * i) / float(kSteps * kSteps);
    float depth = trueHitDepth(map, probe, position + t * reflection);
    if (inFront && depth >= 0.0f)
    {
      float low = before;
      float high = t;
      for (int k = 0; k < kHalvings; ++k)
      {
        float middle = 0.5f * (low + high);
        if (trueHitDepth(map, probe, position + middle * reflection) >= 0.0f) { high = middle; } else { low = middle; }
      }
      TexelHit hit = texelHit(map, probe, faceSize, position, reflection, high);
      // A ray leaves its start surface slowly: in steps of texels it may seem to pass below it again.
      if (!hit.start)
      {
        if (hit.onPlane) { return hit.distance; }
        // Passed behind without a hit: whatever the ray meets from here on is hidden from the capture origin.
        vec3 end = position + high * reflection;
        return trueHitDepth(map, probe, end) < kThick * length(end) * 2.0f / faceSize ? hit.distance : kNoHit;
      }
    }
    inFront = depth < 0.0f;
    before = t;
  }
  return kNoHit;
}
