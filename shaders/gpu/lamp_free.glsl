// Maps without the lamps that are drawn as shapes: alpha holds those lamps' light, the mean of its colours.
uniform float bpLampFree[BP_SLOTS];  // 1 if the slot's map is one of them

// Light of a lookup. Adds the lamps' part of the map, times `weight`, to `inMap`.
vec3 bpWithoutLamps(vec4 value, int slot, float weight, inout float inMap)
{
  inMap += weight * value.a * bpLampFree[slot];
  return value.rgb;
}
