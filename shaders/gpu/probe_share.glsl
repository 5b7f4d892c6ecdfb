#if BP_CONSTANT_SHARES
  float share@SLOT@ = bpShare[@SLOT@] * bpIntensity[@SLOT@];
#else
  float share@SLOT@ = groupShare[@GROUP@] * weight[@SLOT@] * bpIntensity[@SLOT@];
#endif
  if (share@SLOT@ > 1.0e-5f) { bpAddSlot@SLOT@(light, share@SLOT@, position, normal, view, reflection, roughness, fresnel); }
