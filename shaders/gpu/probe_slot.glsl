uniform samplerCube bpMap@SLOT@;

void bpAddSlot@SLOT@(inout BpLight light, float weight, vec3 position, vec3 normal, vec3 view, vec3 reflection, float roughness)
{
  ProbeShape probe;
  probe.boxMin = bpBoxMin[@SLOT@];
  probe.boxMax = bpBoxMax[@SLOT@];
  probe.maxLevel = bpMaxLevel[@SLOT@];
  probe.projection = @PROJECTION@;
  probe.slot = @SLOT@;

  ShadingPoint point;
  point.position = position - bpOrigin[@SLOT@];
  point.normal = normal;
  point.view = view;
  point.reflection = reflection;
  point.roughness = roughness;
#if BP_ROTATED
  mat3 probeFromWorld = transpose(bpWorldFromProbe[@SLOT@]);
  point.position = probeFromWorld * point.position;
  point.normal = probeFromWorld * normal;
  point.view = probeFromWorld * view;
  point.reflection = probeFromWorld * reflection;
#endif

  light.specular += weight * @EVALUATE@(bpMap@SLOT@, probe, point).rgb;
#if BP_DIFFUSE
  light.irradiance += weight * shIrradiance(normal, bpSh[9 * @SLOT@], bpSh[9 * @SLOT@ + 1], bpSh[9 * @SLOT@ + 2],
                                            bpSh[9 * @SLOT@ + 3], bpSh[9 * @SLOT@ + 4], bpSh[9 * @SLOT@ + 5],
                                            bpSh[9 * @SLOT@ + 6], bpSh[9 * @SLOT@ + 7], bpSh[9 * @SLOT@ + 8]);
#endif
}
