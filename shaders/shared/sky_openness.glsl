// How much of an even sky is open at a place, from a texel of filters/core/geometry/sky_openness.h: w is the share of all directions
// that is open, xyz its first moment, 0 to 1 for -0.75 to 0.75 (a half space open along an axis has 0.75 there). What faces `normal` gets
// is exact for anything that is hidden by planes through the place, and without higher moments for the rest.
float skyOpenness(vec4 texel, vec3 normal)
{
  vec3 moment = 1.5f * vec3(texel.x, texel.y, texel.z) - 0.75f;
  return clamp(texel.w + 0.6666667f * dot(moment, normal), 0.0f, 1.0f);
}

// The same of the sky in a reflection, from that of the diffuse light (Lagarde and de Rousiers 2014).
float reflectedOpenness(float open, float nDotV, float roughness)
{
  return clamp(pow(max(nDotV, 0.0f) + open, exp2(-16.0f * roughness * roughness - 1.0f)) - 1.0f + open, 0.0f, 1.0f);
}
