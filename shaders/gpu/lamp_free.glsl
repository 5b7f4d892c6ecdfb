// Probes' maps in which the lamps drawn as shapes do not show: alpha holds those lamps' light in their place. Needs shared/lamp_fade.glsl.
uniform vec3 bpLampTint[BP_SLOTS];  // what alpha is multiplied by
uniform float bpLampFree[BP_SLOTS]; // 1 if the slot's map is such a one

// Light of a lookup, with what the map shows of the lamps.
vec3 bpWithLamps(vec4 value, int slot, float roughness)
{
  return value.rgb + (1.0f - lampsByShape(roughness)) * value.a * bpLampTint[slot];
}
