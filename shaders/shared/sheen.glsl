// Sheen: the lobe of cloth fibres, brightest at grazing angles. Distribution and masking of Estevez and Kulla 2017,
// "Production Friendly Microfacet Sheen BRDF", as in KHR_materials_sheen. Cosines are with the surface's normal.

float sheenAlpha(float roughness)
{
  // Lower values give a lobe too narrow to resolve: 0.07 is a hundredth of the light's angle.
  float r = max(roughness, 0.07f);
  return r * r;
}

// Of half vectors, per solid angle.
float sheenDistribution(float nDotH, float alpha)
{
  float sine = sqrt(max(1.0f - nDotH * nDotH, 0.0f));
  return (2.0f + 1.0f / alpha) * pow(sine, 1.0f / alpha) * 0.15915494f;
}

float sheenMaskingCurve(float x, float alpha)
{
  float t = (1.0f - alpha) * (1.0f - alpha);
  float a = mix(21.5473f, 25.3245f, t);
  float b = mix(3.82987f, 3.32435f, t);
  float c = mix(0.19823f, 0.16801f, t);
  float d = mix(-1.97760f, -1.27393f, t);
  float e = mix(-4.32054f, -4.85967f, t);
  return a / (1.0f + b * pow(x, c)) + d * x + e;
}

float sheenMasking(float cosine, float alpha)
{
  float logarithm = cosine < 0.5f ? sheenMaskingCurve(cosine, alpha)
                                  : 2.0f * sheenMaskingCurve(0.5f, alpha) - sheenMaskingCurve(1.0f - cosine, alpha);
  return exp2(1.44269504f * logarithm);
}

// The lobe without its colour, per steradian and before the cosine.
float sheenLobe(float nDotH, float nDotV, float nDotL, float roughness)
{
  float alpha = sheenAlpha(roughness);
  float masked = (1.0f + sheenMasking(nDotV, alpha) + sheenMasking(nDotL, alpha)) * 4.0f * nDotV * nDotL;
  return sheenDistribution(nDotH, alpha) * clamp(1.0f / max(masked, 1.0e-6f), 0.0f, 1.0f);
}

// Albedo of the lobe at `nDotV`, at most 1: a fit to its integral with a mean error of 0.006, at most 0.04 for cosines
// above 0.02.
float sheenAlbedo(float nDotV, float roughness)
{
  float x = sqrt(clamp(nDotV, 0.0f, 1.0f));
  float y = 1.0f / (max(roughness, 0.07f) + 0.2f);
  float c0 = 0.7271f + y * (-2.0149f + y * (0.97028f - y * 0.1246f));
  float c1 = -3.1823f + y * (8.1046f + y * (-3.269f + y * 0.41111f));
  float c2 = 15.484f + y * (-34.734f + y * (10.907f - y * 1.0683f));
  float c3 = -23.71f + y * (41.756f + y * (-5.9715f - y * 1.2066f));
  float c4 = 7.6507f + y * (-8.1333f + y * (-7.5268f + y * 2.7588f));
  return min(exp2(1.44269504f * (c0 + x * (c1 + x * (c2 + x * (c3 + x * c4))))), 1.0f);
}

// Fraction of light that passes the sheen to the layers below (KHR_materials_sheen, albedo scaling).
float underSheen(vec3 color, float nDotV, float roughness)
{
  return 1.0f - max(color.x, max(color.y, color.z)) * sheenAlbedo(nDotV, roughness);
}
