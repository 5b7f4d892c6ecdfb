// The softness of shadows by a probe's coverage: the level of a chain of plain means of the transmittance, sampled
// where the way from the surface to the light leaves the box.

// Width of a level's texel over the diameter of the light's disc. The edge of a disc's shadow rises from a tenth to
// nine tenths over 0.69 of its diameter; that of a level, means over squares interpolated within the level and with the
// next, over 1.9 texels; that of the unfiltered capture over 1.1. Between them the width is interpolated.
const float kCoverageWidth = 0.37f;

// `hit`: from the capture origin to where the way leaves the box; `factors`: slab factors of that way, the smallest of
// which is its length; `tangent`: of half the light's apparent angle. The disc is projected on the wall and measured by
// its area as seen from the capture origin.
float coverageLevel(vec3 hit, vec3 factors, vec3 toLight, float tangent, float faceSize)
{
  vec3 a = abs(hit);
  float largest = max(max(a.x, a.y), a.z);
  float d = min(min(factors.x, factors.y), factors.z);
  // A capture origin at the hit itself sees it from nowhere; lengths below 1e-30 count as 0.
  if (largest <= 1.0e-30f || d >= kNoHit) { return 0.0f; }
  vec3 onFace = vec3(factors.x <= d ? 1.0f : 0.0f, factors.y <= d ? 1.0f : 0.0f, factors.z <= d ? 1.0f : 0.0f);
  float slant = length(hit / largest);  // of the direction in its face: texels there are smaller by this to the power of 1.5
  float cosineC = clamp(dot(onFace, a / largest) / slant, 1.0e-3f, 1.0f);
  float cosineP = clamp(dot(onFace, abs(toLight)), 1.0e-3f, 1.0f);
  float texels = min(d / largest, 1.0e12f) * min(tangent, 1.0e6f) * sqrt(cosineC / cosineP) * faceSize * sqrt(slant);
  float width = kCoverageWidth * texels;
  return width < 2.0f ? clamp(0.71f * width - 0.42f, 0.0f, 1.0f) : log2(width);
}

// `from`: the surface, `toLight`: unit, both probe frame; `perUnit`: levels per scene unit of distance, negative: by
// the light's size.
CoverageLook coverageLook(vec3 from, vec3 toLight, vec3 boxMin, vec3 boxMax, float tangent, float perUnit, float faceSize)
{
  vec3 factors = slabFactors(from, toLight, boxMin, boxMax);
  CoverageLook look;
  look.distance = min(min(factors.x, factors.y), factors.z);
  look.hit = from + look.distance * toLight;
  look.level = perUnit < 0.0f ? coverageLevel(look.hit, factors, toLight, tangent, faceSize) : look.distance * perUnit;
  return look;
}
