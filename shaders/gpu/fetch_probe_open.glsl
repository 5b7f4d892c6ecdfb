// The GPU's side of `fetchProbe` where the sky shows through: what gpu/fetch_probe.glsl gives, and for what it does not cover the
// sky, uncorrected, along the way from the surface to where the lookup meets the box, as narrow as the lookup is from there.
// Techniques of several lookups tell by their directions which part of their lobe the openings take; gpu/open_sky.glsl, one sky
// for the whole lobe, cannot. Set by the slot before it evaluates:
vec3 bpOpenFrom;           // P - C, probe frame
float bpOpenAlpha;         // of the surface
bool bpOpenHere = false;

vec4 fetchProbe(PROBE_MAP map, ProbeShape probe, vec3 direction, float level)
{
#if BP_DEBUG
  bpTraceFetch(level, probe.maxLevel);
#endif
#if BP_ROTATED
  vec4 value = BP_SLOT_LOOKUP(map, probe.slot, bpMapFromProbe[probe.slot] * lookupDirection(direction), level);
#else
  vec4 value = BP_SLOT_LOOKUP(map, probe.slot, lookupDirection(direction), level);
#endif
  float open = clamp(1.0f - value.a, 0.0f, 1.0f) * bpSkyIntensity;
  if (!bpOpenHere || open <= 0.0f) { return value; }
  vec4 sky = openLookup(probe, bpOpenFrom, direction, clamp(level, 0.0f, probe.maxLevel), bpOpenAlpha);
#if BP_ROTATED
  vec3 along = bpWorldFromProbe[probe.slot] * sky.xyz;
#else
  vec3 along = sky.xyz;
#endif
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
  value.rgb += open * BP_SKY_LOOKUP(along, levelForRoughness(sky.w, bpSkyMaxLevel)).rgb;
  return value;
}
