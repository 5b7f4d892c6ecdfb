  float share@SLOT@ = bpShareOf[@SLOT@] * bpIntensity[@SLOT@];
#if BP_WEIGHTS
  if (share@SLOT@ > 1.0e-5f)
#endif
  { bpAddSlot@SLOT@(light, share@SLOT@, position, normal, view, reflection, roughness, fresnel, f0); }
