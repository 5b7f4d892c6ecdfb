// The whole lobe as one footprint; see shared/footprint.glsl. The factors are a fit.
vec4 evaluateFootprint1(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  float p = clamp(point.roughness, 0.0f, 1.0f);
  float a = p * p;
  float nv = clamp(dot(point.normal, point.view), 0.0f, 1.0f);
  return footprintMean(map, probe, point, a * (1.85f - 1.75f * nv), a * a * (1.55f - 0.40f * a), -0.4f);
}
