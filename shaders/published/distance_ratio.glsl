// For comparison and teaching only: roughness by HDRP's and Frostbite's distance ratio (Lagarde and de Rousiers 2014), the quotient
// as it is printed: 0 / 0 where P and C lie in the same point of a wall.
float publishedDistanceRoughness(float hitDistance, vec3 lookup, float roughness)
{
  float sharper = clamp(hitDistance / length(lookup) * roughness, 0.0f, roughness);
  return mix(sharper, roughness, roughness);
}
