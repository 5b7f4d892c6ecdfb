// The second half of the split sum (Karis 2013): multiplies the mean light of a lobe by A F0 + B F90. The table of A
// and B is filters/math/sampling/brdf_table.h; A + B is the albedo of a perfectly reflecting surface (F0 = F90 = 1).

// Texture coordinates in a table of `size` texels per side: N.V across, perceptual roughness up, both ends at the
// centre of a texel. The root gives more texels to grazing views, where a smooth surface's masking starts.
vec2 splitSumPlace(float cosine, float roughness, float size)
{
  return vec2(sqrt(clamp(cosine, 0.0f, 1.0f)), clamp(roughness, 0.0f, 1.0f)) * ((size - 1.0f) / size) + vec2(0.5f / size);
}

// The same for roughness 0: one microfacet without masking.
vec2 smoothSplitSum(float cosine)
{
  float c = 1.0f - clamp(cosine, 0.0f, 1.0f);
  float c2 = c * c;
  float b = c2 * c2 * c;
  return vec2(1.0f - b, b);
}

// Factor that adds back light that leaves the microfacets after more than one reflection (Turquin 2019): what one
// reflection loses of white light, 1 - E, returns coloured by F0.
vec3 multipleScattering(vec3 f0, vec2 splitSum)
{
  float albedo = max(splitSum.x + splitSum.y, 1.0e-3f);
  return vec3(1.0f) + f0 * ((1.0f - albedo) / albedo);
}

// Fraction of light that a clear coat at `cosine` transmits to its base. Includes light reflected back and forth
// between the two, so that a white mirror stays white (KHR_materials_clearcoat).
float coatPasses(float strength, float coatF0, float cosine)
{
  return 1.0f - strength * schlickFresnel(vec3(coatF0), vec3(1.0f), cosine).x;
}
