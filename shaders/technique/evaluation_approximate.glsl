// Contact hardening by distance alone: a mirror where the surface touches the wall, its own roughness from
// hardeningLength S on, level = mix(0, level of p, clamp(d, 0, S) / S). Published with S = 6. The level depends on a
// length, not on the lobe, so the result changes with the size of the room and the resolution of the capture; without a
// proxy (d huge) there is no hardening.
vec4 evaluateApproximate(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float reach = max(probe.parameters.hardeningLength, 1.0e-30f);  // avoids division by 0
  float level = levelForCurve(probe, point.roughness) * (clamp(hit.distance, 0.0f, reach) / reach);
  return fetchLevel(map, probe, hit.direction, level);
}
