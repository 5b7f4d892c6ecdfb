// The stress test's maps on the GPU: a lookup returns its own direction and level, so that errors in either show in the
// result; distances are those of filters/stress/stress_map.h. Needs shared/types.glsl, finite.glsl, slab.glsl and
// relief.glsl.
#define PROBE_MAP int
#define DISTANCE_MAP int

vec3 stressLargestOne(vec3 d)
{
  return d / max(max(abs(d.x), abs(d.y)), max(abs(d.z), 1.0e-37f));
}

vec4 fetchProbe(int map, ProbeShape probe, vec3 direction, float level)
{
  return vec4(stressLargestOne(lookupDirection(direction)), level);
}

vec2 stressBlueNoise;  // of the input's pixel, set by main()

vec2 fetchBlueNoise(ivec2 pixel)
{
  return stressBlueNoise;
}

vec2 stressSplitSum;  // of the input's surface, set by main()

vec2 splitSumAt(float cosine, float roughness)
{
  return stressSplitSum;
}

// From the light table of filters/stress/stress_light.h; the box is not rotated against the map.
#define STRESS_LIGHT_CELLS 96
uniform vec4 stressLight[STRESS_LIGHT_CELLS];
vec3 mapFromProbe(ProbeShape probe, vec3 direction) { return direction; }
vec3 probeFromMap(ProbeShape probe, vec3 direction) { return direction; }
int probeLightSize(ProbeShape probe) { return 4; }
vec4 fetchProbeLight(ProbeShape probe, int cell) { return stressLight[clamp(cell, 0, STRESS_LIGHT_CELLS - 1)]; }

float stressDistance(ProbeShape probe, vec3 direction)
{
  vec3 q = stressLargestOne(direction);
  vec3 walls = slabFactors(vec3(0.0f), q, probe.boxMin, probe.boxMax);
  float t = min(min(walls.x, walls.y), walls.z);
  return q.z > 0.9f ? 0.0f : min(t, 1.0e30f) * length(q) * (0.8f + 0.2f * q.x * q.y);
}

float fetchDistance(int map, ProbeShape probe, vec3 direction)
{
  return stressDistance(probe, direction);
}

vec3 fetchProbePlane(ProbeShape probe, vec3 direction)
{
  vec3 q = stressLargestOne(direction);
  float seen = stressDistance(probe, direction);
  return seen > 1.0e-30f ? q / (length(q) * seen) : vec3(0.0f);
}

vec3 fetchProbeFar(ProbeShape probe, vec3 direction)
{
  vec3 q = stressLargestOne(direction);
  return reliefFar(q.z > 0.9f ? -2.0f : (q.x > 0.9f ? -1.0f : 4096.0f * 2048.0f + 2048.0f), direction);
}

vec3 reliefFromProbe(ProbeShape probe, vec3 v) { return v; }
float probeReliefSize(ProbeShape probe) { return 64.0f; }
vec4 fetchProbeRelief(ProbeShape probe, vec3 direction, float level)
{
  vec3 q = stressLargestOne(direction);
  float seen = stressDistance(probe, direction);
  vec3 plane = fetchProbePlane(probe, direction);
  if (level > 0.5f) { return vec4(plane, seen > 1.0e-30f ? 0.5f * level / seen : 0.0f); }
  return vec4(plane, q.z > 0.9f ? -2.0f : (q.x > 0.9f ? -1.0f : 4096.0f * 2048.0f + 2048.0f));
}

int probeBlockCount(ProbeShape probe) { return 2; }
vec3 probeBlockLow(ProbeShape probe, int i) { return probe.boxMin + (i == 0 ? 0.1f : 0.6f) * (probe.boxMax - probe.boxMin); }
vec3 probeBlockHigh(ProbeShape probe, int i)
{
  return probeBlockLow(probe, i) + (i == 0 ? 0.2f : 0.4f) * (probe.boxMax - probe.boxMin);
}
