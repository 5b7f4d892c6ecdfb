// Where light goes nearly straight through, what is drawn behind stands in for its lookup, in proportion. Lies within VTK's main().
  float bpStands = bpGlassStands(bpGlass, bpPassed);
  color = max(color - bpStands * bpGlass.looked, vec3(0.0)) / max(1.0 - bpStands, 1.0e-4);
  opacity = 1.0 - bpStands;
