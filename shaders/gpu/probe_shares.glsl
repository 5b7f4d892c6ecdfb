// The shares of the draw's probes and the sky in the pixel: spliced in by filters/vtk/surface/probe_source.cpp, once
// for both reflections and shadows. Needs shared/weights.glsl.
#if BP_SLOTS > 0
float bpShareOf[BP_SLOTS];  // before intensity; set by bpShareOut
#endif

// `position`: relative to the eye, world axes. Returns the sky's share.
float bpShareOut(vec3 position)
{
#if BP_SLOTS == 0
  return 1.0f;
#elif !BP_WEIGHTS
  bpShareOf[0] = 1.0f;
  return 0.0f;
#elif BP_CONSTANT_SHARES
  for (int i = 0; i < BP_SLOTS; ++i) { bpShareOf[i] = bpShare[i]; }
  return bpSkyShare;
#else
  float remaining = 1.0f;
  float weight[BP_SLOTS];
  float groupSum[BP_GROUPS];
  float share[BP_GROUPS];
  for (int g = 0; g < BP_GROUPS; ++g) { groupSum[g] = 0.0f; }
//BP::Weights
  for (int g = 0; g < BP_GROUPS; ++g)
  {
    share[g] = groupShare(remaining, groupSum[g]);
    remaining = remainingAfter(remaining, groupSum[g]);
  }
#if BP_ONLY_PROBES
  for (int g = 0; g < BP_GROUPS; ++g) { share[g] = share[g] * onlyProbesScale(remaining); }
  remaining = onlyProbesRemaining(remaining);
#endif
//BP::Shares
  return remaining;
#endif
}
