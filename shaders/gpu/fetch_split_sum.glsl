// The GPU's side of the split-sum table: see shared/split_sum.glsl, which stands before this. BP_VTK_TABLE: the table is VTK's own, for
// comparisons with it.
uniform sampler2D bpBrdf;

vec2 bpSplitSum(float cosine, float roughness)
{
#ifdef BP_VTK_TABLE
  return texture(bpBrdf, vec2(cosine, roughness)).rg;
#else
  return texture(bpBrdf, splitSumPlace(cosine, roughness, BP_BRDF_SIZE)).rg;
#endif
}

// The surface's own, which may be known to be perfectly smooth.
vec2 bpSurfaceSum(float cosine, float roughness)
{
#if defined(BP_SMOOTH) && !defined(BP_VTK_TABLE)
  return smoothSplitSum(cosine);
#else
  return bpSplitSum(cosine, roughness);
#endif
}

// The name that techniques know it by.
vec2 splitSumAt(float cosine, float roughness)
{
  return bpSplitSum(cosine, roughness);
}
