uniform samplerCube bpThroughMap@SLOT@;
uniform float bpThroughFaceSize@SLOT@;
uniform float bpThroughPerUnit@SLOT@;  // levels per unit unless the light sets it

vec3 bpThroughSlot@SLOT@(vec3 position, vec3 toLight, float tangent, float perUnit)
{
  vec3 from = position - bpOrigin[@SLOT@];
#if BP_ROTATED
  from = transpose(bpWorldFromProbe[@SLOT@]) * from;
  toLight = transpose(bpWorldFromProbe[@SLOT@]) * toLight;
#endif
  CoverageLook look = coverageLook(from, toLight, bpBoxMin[@SLOT@], bpBoxMax[@SLOT@], tangent,
                                   perUnit == 0.0f ? bpThroughPerUnit@SLOT@ : perUnit, bpThroughFaceSize@SLOT@);
  vec3 hit = look.hit;
#if BP_ROTATED
  hit = bpMapFromProbe[@SLOT@] * hit;
#endif
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
  return textureLod(bpThroughMap@SLOT@, lookupDirection(hit), look.level).rgb;
}
