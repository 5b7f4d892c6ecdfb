// Probes' maps in which the lamps drawn as shapes do not show: alpha holds those lamps' light, the mean of its colours, in their place.
uniform float bpLampFree[BP_SLOTS]; // 1 if the slot's map is such a one

// Light of a lookup. What the map shows of the lamps, times `weight`, is put by.
vec3 bpWithoutLamps(vec4 value, int slot, float weight, inout float inMap)
{
  inMap += weight * value.a * bpLampFree[slot];
  return value.rgb;
}
