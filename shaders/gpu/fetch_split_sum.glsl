// The split-sum table on the GPU; follows shared/split_sum.glsl. BP_VTK_TABLE: the table is VTK's own, for comparisons
// with it.
uniform sampler2D bpBrdf;

vec2 bpSplitSum(float cosine, float roughness)
{
#ifdef BP_VTK_TABLE
  return texture(bpBrdf, vec2(cosine, roughness)).rg;
#else
  return texture(bpBrdf, splitSumPlace(cosine, roughness, BP_BRDF_SIZE)).rg;
#endif
}

// For the surface itself, which may be known to be perfectly smooth.
vec2 bpSurfaceSum(float cosine, float roughness)
{
#if defined(BP_SMOOTH) && !defined(BP_VTK_TABLE)
  return smoothSplitSum(cosine);
#else
  return bpSplitSum(cosine, roughness);
#endif
}

// The name that techniques use.
vec2 splitSumAt(float cosine, float roughness)
{
  return bpSplitSum(cosine, roughness);
}
