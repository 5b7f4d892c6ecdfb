// `fetchProbe` on the GPU: direction in the probe's frame, level of its prefiltered chain.
vec4 fetchProbe(PROBE_MAP map, ProbeShape probe, vec3 direction, float level)
{
#if BP_DEBUG
  bpTraceFetch(level, probe.maxLevel);
#endif
#if BP_ROTATED
  return BP_SLOT_LOOKUP(map, probe.slot, bpMapFromProbe[probe.slot] * lookupDirection(direction), level);
#else
  return BP_SLOT_LOOKUP(map, probe.slot, lookupDirection(direction), level);
#endif
}
