  float share@SLOT@ = groupShare[@GROUP@] * weight[@SLOT@] * bpIntensity[@SLOT@];
  if (share@SLOT@ > 1.0e-5f) { bpAddSlot@SLOT@(light, share@SLOT@, position, normal, view, reflection, roughness, fresnel); }
