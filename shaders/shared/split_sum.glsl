// What turns the mean light of a lobe into reflected light (the second half of the split sum, Karis 2013): A F0 + B F90. The table of
// A and B is filters/math/sampling/brdf_table.h; A + B is the albedo of a surface that reflects all (F0 = F90 = 1).

// Where the table of `size` texels a side holds them: N.V across, perceptual roughness up, both ends at the centre of a texel. The root
// spends more texels on grazing views, where a smooth surface's masking sets in.
vec2 splitSumPlace(float cosine, float roughness, float size)
{
  return vec2(sqrt(clamp(cosine, 0.0f, 1.0f)), clamp(roughness, 0.0f, 1.0f)) * ((size - 1.0f) / size) + vec2(0.5f / size);
}

// The same where roughness is 0: one microfacet, masked by nothing.
vec2 smoothSplitSum(float cosine)
{
  float c = 1.0f - clamp(cosine, 0.0f, 1.0f);
  float c2 = c * c;
  float b = c2 * c2 * c;
  return vec2(1.0f - b, b);
}

// Factor that adds back the light which leaves the microfacets after more than one reflection (Turquin 2019): what one reflection
// loses of white light, 1 - E, comes out coloured by F0.
vec3 multipleScattering(vec3 f0, vec2 splitSum)
{
  float albedo = max(splitSum.x + splitSum.y, 1.0e-3f);
  return vec3(1.0f) + f0 * ((1.0f - albedo) / albedo);
}

// Share of light that a clear coat, seen at `cosine` to its normal, leaves to its base: what it does not reflect itself. Light that goes
// back and forth between the two is with it, so that a white mirror stays one (KHR_materials_clearcoat).
float coatPasses(float strength, float coatF0, float cosine)
{
  return 1.0f - strength * schlickFresnel(vec3(coatF0), vec3(1.0f), cosine).x;
}
