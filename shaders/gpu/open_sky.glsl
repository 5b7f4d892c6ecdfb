  // The sky where the probe saw nothing: along R, because it is infinitely far away. Part of gpu/probe_slot.glsl.
  // Filtered levels are premultiplied, so covered and open parts add up without a rim.
  float open = clamp(1.0f - local.a, 0.0f, 1.0f) * bpSkyIntensity;
  specular += open * BP_SKY_LOOKUP(reflection, levelForRoughness(roughness, bpSkyMaxLevel)).rgb;
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
