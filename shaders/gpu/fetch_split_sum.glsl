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

// What a surface that reflects all keeps of white light after one reflection.
float whiteAlbedo(float cosine, float roughness)
{
  vec2 sum = bpSplitSum(cosine, roughness);
  return sum.x + sum.y;
}
