// The GPU's side of what projection `impostor` asks of a probe: its relief (filters/math/cube/relief.h), nearest texel, and blocks. GLSL
// has no arrays of samplers to choose from, so the slot is chosen by comparisons, which the compiler decides: it is a constant.
// Needs shared/relief.glsl.
#define BP_MOST_BLOCKS 8
uniform int bpBlockCount[BP_SLOTS];
uniform vec3 bpBlockLow[BP_MOST_BLOCKS * BP_SLOTS];   // probe frame
uniform vec3 bpBlockHigh[BP_MOST_BLOCKS * BP_SLOTS];
uniform samplerCube bpRelief0;
#if BP_SLOTS > 1
uniform samplerCube bpRelief1;
#endif
#if BP_SLOTS > 2
uniform samplerCube bpRelief2;
#endif
#if BP_SLOTS > 3
uniform samplerCube bpRelief3;
#endif

vec4 bpFetchRelief(ProbeShape probe, vec3 direction)
{
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
#if BP_ROTATED
  vec3 inMap = bpMapFromProbe[probe.slot] * direction;
#else
  vec3 inMap = direction;
#endif
#if BP_SLOTS > 1
  if (probe.slot == 1) { return textureLod(bpRelief1, inMap, 0.0f); }
#endif
#if BP_SLOTS > 2
  if (probe.slot == 2) { return textureLod(bpRelief2, inMap, 0.0f); }
#endif
#if BP_SLOTS > 3
  if (probe.slot == 3) { return textureLod(bpRelief3, inMap, 0.0f); }
#endif
  return textureLod(bpRelief0, inMap, 0.0f);
}

vec3 fetchProbePlane(ProbeShape probe, vec3 direction)
{
  vec3 plane = bpFetchRelief(probe, direction).xyz;
#if BP_ROTATED
  plane = transpose(bpMapFromProbe[probe.slot]) * plane;
#endif
  return plane;
}

vec3 fetchProbeFar(ProbeShape probe, vec3 direction)
{
#if BP_ROTATED
  return transpose(bpMapFromProbe[probe.slot]) *
         reliefFar(bpFetchRelief(probe, direction).w, bpMapFromProbe[probe.slot] * direction);
#else
  return reliefFar(bpFetchRelief(probe, direction).w, direction);
#endif
}

int probeBlockCount(ProbeShape probe) { return bpBlockCount[probe.slot]; }
vec3 probeBlockLow(ProbeShape probe, int i) { return bpBlockLow[BP_MOST_BLOCKS * probe.slot + i]; }
vec3 probeBlockHigh(ProbeShape probe, int i) { return bpBlockHigh[BP_MOST_BLOCKS * probe.slot + i]; }
