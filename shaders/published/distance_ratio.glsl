// For comparison and teaching only: roughness by HDRP's and Frostbite's distance ratio (Lagarde and de Rousiers 2014),
// with the quotient as printed: 0 / 0 if P and C coincide in a wall.
float publishedDistanceRoughness(float hitDistance, vec3 lookup, float roughness)
{
  float sharper = clamp(hitDistance / length(lookup) * roughness, 0.0f, roughness);
  return mix(sharper, roughness, roughness);
}
