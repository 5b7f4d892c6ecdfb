  // The sky where the probe saw nothing: along R itself, for it is infinitely far away. Lies within gpu/probe_slot.glsl; its
  // filtered levels are premultiplied, so what they cover and what they leave open add up to one picture without a rim.
  float open = clamp(1.0f - local.a, 0.0f, 1.0f) * bpSkyIntensity;
  specular += open * BP_SKY_LOOKUP(reflection, levelForRoughness(roughness, bpSkyMaxLevel)).rgb;
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
