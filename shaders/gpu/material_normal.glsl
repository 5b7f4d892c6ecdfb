// Normal maps; part of VTK's main(), after the vertex normal was turned towards the eye. On the back of a double-sided
// surface the frame is reversed, so that a dent on one side is a bump on the other.
#if BP_TANGENT
  float bpSide = gl_FrontFacing ? 1.0f : -1.0f;
#if defined(CLEAR_COAT) && defined(BP_HAS_CoatNormal)
  coatNormalVCVSOutput = bpSide * bpMappedNormal(bpSide * normalVCVSOutput, bpSampleCoatNormal().rgb, bpCoatNormalScale);
#endif
#ifdef BP_HAS_Normal
  normalVCVSOutput = bpSide * bpMappedNormal(bpSide * normalVCVSOutput, bpSampleNormal().rgb, bpNormalScale);
#endif
#endif
