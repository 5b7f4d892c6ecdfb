// No contact hardening: one fetch from the level of the surface's own roughness, independent of the distance to the
// hit.
vec4 evaluateNone(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  return fetchLevel(map, probe, hit.direction, levelForCurve(probe, point.roughness));
}
