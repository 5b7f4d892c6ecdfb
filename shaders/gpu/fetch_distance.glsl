// The GPU's side of `fetchProbeDistance`: direction in the probe's frame, the nearest texel, 0 where the probe saw nothing. GLSL has
// no arrays of samplers to choose from, so the slot is chosen by comparisons, which the compiler decides: it is a constant.
float fetchProbeDistance(ProbeShape probe, vec3 direction)
{
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
#if BP_ROTATED
  vec3 world = bpWorldFromProbe[probe.slot] * direction;
#else
  vec3 world = direction;
#endif
#if BP_SLOTS > 1
  if (probe.slot == 1) { return textureLod(bpDistanceMap1, world, 0.0f).r; }
#endif
#if BP_SLOTS > 2
  if (probe.slot == 2) { return textureLod(bpDistanceMap2, world, 0.0f).r; }
#endif
#if BP_SLOTS > 3
  if (probe.slot == 3) { return textureLod(bpDistanceMap3, world, 0.0f).r; }
#endif
  return textureLod(bpDistanceMap0, world, 0.0f).r;
}
