  vec3 local@SLOT@ = position - bpOrigin[@SLOT@];
#if BP_ROTATED
  local@SLOT@ = transpose(bpWorldFromProbe[@SLOT@]) * local@SLOT@;
#endif
  weight[@SLOT@] = influenceWeight(local@SLOT@, bpInfluenceMin[@SLOT@], bpInfluenceMax[@SLOT@], bpRateMin[@SLOT@],
                                   bpRateMax[@SLOT@]);
  groupSum[@GROUP@] += weight[@SLOT@];
