// The masking term of the split sum that is printed most often (Karis 2013, k = alpha / 2 for image-based light): a fit
// to Smith's that removes more light. One sample of the two factors, for the half vector `h` of a surface seen at
// `cosine` to its normal.
float publishedSmithFit(float c, float alpha)
{
  float k = 0.5f * alpha;
  return c / (c * (1.0f - k) + k);
}

vec2 publishedSplitSumSample(vec3 h, float cosine, float alpha)
{
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  float viewHalf = sine * h.x + cosine * h.z;
  float light = 2.0f * viewHalf * h.z - cosine;
  if (light <= 0.0f || viewHalf <= 0.0f) { return vec2(0.0f); }
  float visible = publishedSmithFit(cosine, alpha) * publishedSmithFit(light, alpha) * viewHalf / (h.z * cosine);
  float fresnel = pow(1.0f - min(viewHalf, 1.0f), 5.0f);
  return vec2((1.0f - fresnel) * visible, fresnel * visible);
}
