// `fetchProbe` on the GPU for probes through which the sky shows: the value of gpu/fetch_probe.glsl and, where it has
// no coverage, the sky along the way from the surface to the lookup's hit on the box, with the lobe's width there. It
// is not box-projected. Techniques with several lookups find by their directions which part of the lobe the openings
// take; gpu/open_sky.glsl, one sky for the whole lobe, cannot. Set by the slot before it evaluates:
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
