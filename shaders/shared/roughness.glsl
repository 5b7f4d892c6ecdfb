// Conversion between roughness and prefiltered level, in both directions. A texel of level l is 2^l times as wide as
// one of level 0. The mapping makes the lobe grow with it: alpha = roughness² rises as (2^l - 1), from 0 at level 0
// (the capture itself) to 1 at the last level, so every level resolves its lobe equally well.

float roughnessForLevel(float level, float maxLevel)
{
  return maxLevel > 0.0f ? sqrt((exp2(clamp(level, 0.0f, maxLevel)) - 1.0f) / (exp2(maxLevel) - 1.0f)) : 0.0f;
}

// `alpha` in [0, 1].
float levelForAlpha(float alpha, float maxLevel)
{
  return min(log2(1.0f + alpha * (exp2(maxLevel) - 1.0f)), maxLevel);
}

float levelForRoughness(float roughness, float maxLevel)
{
  float p = clamp(roughness, 0.0f, 1.0f);
  return levelForAlpha(p * p, maxLevel);
}
