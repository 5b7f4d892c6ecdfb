// The functions that projection `impostor` needs, on the GPU: a probe's relief (filters/math/cube/relief.h), nearest
// texel and level, and its blocks. GLSL cannot index samplers dynamically, so the slot is selected by comparisons,
// which the compiler resolves because it is a constant. Needs shared/relief.glsl.
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

vec3 reliefFromProbe(ProbeShape probe, vec3 v)
{
#if BP_ROTATED
  return bpMapFromProbe[probe.slot] * v;
#else
  return v;
#endif
}

vec4 fetchProbeRelief(ProbeShape probe, vec3 inMap, float level)
{
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
#if BP_SLOTS > 1
  if (probe.slot == 1) { return textureLod(bpRelief1, inMap, level); }
#endif
#if BP_SLOTS > 2
  if (probe.slot == 2) { return textureLod(bpRelief2, inMap, level); }
#endif
#if BP_SLOTS > 3
  if (probe.slot == 3) { return textureLod(bpRelief3, inMap, level); }
#endif
  return textureLod(bpRelief0, inMap, level);
}

float probeReliefSize(ProbeShape probe)
{
#if BP_SLOTS > 1
  if (probe.slot == 1) { return float(textureSize(bpRelief1, 0).x); }
#endif
#if BP_SLOTS > 2
  if (probe.slot == 2) { return float(textureSize(bpRelief2, 0).x); }
#endif
#if BP_SLOTS > 3
  if (probe.slot == 3) { return float(textureSize(bpRelief3, 0).x); }
#endif
  return float(textureSize(bpRelief0, 0).x);
}

vec3 fetchProbePlane(ProbeShape probe, vec3 direction)
{
  vec3 plane = fetchProbeRelief(probe, reliefFromProbe(probe, direction), 0.0f).xyz;
#if BP_ROTATED
  plane = transpose(bpMapFromProbe[probe.slot]) * plane;
#endif
  return plane;
}

vec3 fetchProbeFar(ProbeShape probe, vec3 direction)
{
  vec3 inMap = reliefFromProbe(probe, direction);
  vec3 away = reliefFar(fetchProbeRelief(probe, inMap, 0.0f).w, inMap);
#if BP_ROTATED
  away = transpose(bpMapFromProbe[probe.slot]) * away;
#endif
  return away;
}

int probeBlockCount(ProbeShape probe) { return bpBlockCount[probe.slot]; }
vec3 probeBlockLow(ProbeShape probe, int i) { return bpBlockLow[BP_MOST_BLOCKS * probe.slot + i]; }
vec3 probeBlockHigh(ProbeShape probe, int i) { return bpBlockHigh[BP_MOST_BLOCKS * probe.slot + i]; }
