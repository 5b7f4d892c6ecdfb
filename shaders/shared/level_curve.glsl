// The level for a roughness, by the curves of various renderers: 0 own, 1 unity, 2 linear, 3 exact, 4 marmoset, 5
// three-level (parameter `curve`). Only `own` matches how this project's levels are filtered; the others show the
// effect of a mismatch. All run from level 0 at roughness 0 to the last level at roughness 1. Needs
// shared/roughness.glsl; the host supplies PROBE_MAP and fetchProbe.

// Fraction of the chain for a roughness in [0, 1].
float unityCurve(float p)
{
  return p * (1.7f - 0.7f * p);
}

// What unityCurve approximates: the roughness whose Blinn-Phong exponent n = 2 / alpha² - 2 is a quarter as large,
// which compensates for lobes filtered around R instead of the half vector. (2 / (n/4 + 2))^(1/4), multiplied out so
// that roughness 0 does not divide by 0.
float exactCurve(float p)
{
  float p4 = p * p * p * p;
  return p * sqrt(sqrt(4.0f / (1.0f + 3.0f * p4)));
}

float levelForCurve(ProbeShape probe, float roughness)
{
  float p = clamp(roughness, 0.0f, 1.0f);
  int curve = probe.parameters.curve;
  if (curve == 1) { return unityCurve(p) * probe.maxLevel; }
  if (curve == 2 || curve == 5) { return p * probe.maxLevel; }
  if (curve == 3) { return min(exactCurve(p), 1.0f) * probe.maxLevel; }
  if (curve == 4) { return sqrt(p * sqrt(p)) * probe.maxLevel; }
  return levelForRoughness(p, probe.maxLevel);
}

// One fetch; the three-level curve takes two, because it interpolates between the first, the middle and the last level
// only (0, 4 and 8 of a chain of nine).
vec4 fetchLevel(PROBE_MAP map, ProbeShape probe, vec3 direction, float level)
{
  if (probe.parameters.curve == 5)
  {
    float middle = floor(0.5f * probe.maxLevel + 0.5f);
    bool upper = level > middle;
    float low = upper ? middle : 0.0f;
    float high = upper ? probe.maxLevel : middle;
    float share = high > low ? clamp((level - low) / (high - low), 0.0f, 1.0f) : 0.0f;
    return (1.0f - share) * fetchProbe(map, probe, direction, low) + share * fetchProbe(map, probe, direction, high);
  }
  return fetchProbe(map, probe, direction, level);
}
