// The GPU's side of `fetchProbe`: direction in the probe's frame, level of its prefiltered chain.
vec4 fetchProbe(samplerCube map, ProbeShape probe, vec3 direction, float level)
{
#if BP_DEBUG
  bpTraceFetch(level, probe.maxLevel);
#endif
#if BP_ROTATED
  return textureLod(map, bpMapFromProbe[probe.slot] * lookupDirection(direction), level);
#else
  return textureLod(map, lookupDirection(direction), level);
#endif
}
