// The functions that shared/light_sampling.glsl needs, on the GPU. BP_LIGHT: a technique of the draw uses them.
#if BP_ROTATED
vec3 mapFromProbe(ProbeShape probe, vec3 direction) { return bpMapFromProbe[probe.slot] * direction; }
vec3 probeFromMap(ProbeShape probe, vec3 direction) { return transpose(bpMapFromProbe[probe.slot]) * direction; }
#else
vec3 mapFromProbe(ProbeShape probe, vec3 direction) { return direction; }
vec3 probeFromMap(ProbeShape probe, vec3 direction) { return direction; }
#endif
#if BP_LIGHT
uniform int bpLightSize[BP_SLOTS];  // cells along a face; 0: no table
uniform sampler2D bpLight0;  // one row of cells per row
#if BP_SLOTS > 1
uniform sampler2D bpLight1;
#endif
#if BP_SLOTS > 2
uniform sampler2D bpLight2;
#endif
#if BP_SLOTS > 3
uniform sampler2D bpLight3;
#endif
int probeLightSize(ProbeShape probe) { return bpLightSize[probe.slot]; }
vec4 fetchProbeLight(ProbeShape probe, int cell)
{
  int size = max(bpLightSize[probe.slot], 1);
  ivec2 at = ivec2(cell % size, cell / size);
#if BP_SLOTS > 1
  if (probe.slot == 1) { return texelFetch(bpLight1, at, 0); }
#endif
#if BP_SLOTS > 2
  if (probe.slot == 2) { return texelFetch(bpLight2, at, 0); }
#endif
#if BP_SLOTS > 3
  if (probe.slot == 3) { return texelFetch(bpLight3, at, 0); }
#endif
  return texelFetch(bpLight0, at, 0);
}
#else
int probeLightSize(ProbeShape probe) { return 0; }
vec4 fetchProbeLight(ProbeShape probe, int cell) { return vec4(0.0f); }
#endif
