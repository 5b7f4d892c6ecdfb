// Normal maps; lies within VTK's main(), after it has the vertex normal turned towards the eye. The back of a double-sided
// surface has the whole frame turned round, so that what is a dent from one side is a bump from the other.
#if BP_TANGENT
  float bpSide = gl_FrontFacing ? 1.0f : -1.0f;
#if defined(CLEAR_COAT) && defined(BP_HAS_CoatNormal)
  coatNormalVCVSOutput = bpSide * bpMappedNormal(bpSide * normalVCVSOutput, bpSampleCoatNormal().rgb, bpCoatNormalScale);
#endif
#ifdef BP_HAS_Normal
  normalVCVSOutput = bpSide * bpMappedNormal(bpSide * normalVCVSOutput, bpSampleNormal().rgb, bpNormalScale);
#endif
#endif
