// Blends in the frame behind where light passes nearly straight. Part of VTK's main().
  float bpStands = bpGlassStands(bpGlass, bpPassed);
  color = max(color - bpStands * bpGlass.looked, vec3(0.0)) / max(1.0 - bpStands, 1.0e-4);
  opacity = 1.0 - bpStands;
