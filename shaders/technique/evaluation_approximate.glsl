// Contact hardening by the plain distance: a mirror where the surface touches the wall, its own roughness from hardeningLength S
// on, level = mix(0, level of p, clamp(d, 0, S) / S). Published with S = 6. The level rises with a length, not with the lobe, so a
// bigger room or a coarser capture looks different; without a proxy to hit (d huge) nothing is hardened.
vec4 evaluateApproximate(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float reach = max(probe.parameters.hardeningLength, 1.0e-30f);  // a length of 0 divides nothing by 0
  float level = levelForCurve(probe, point.roughness) * (clamp(hit.distance, 0.0f, reach) / reach);
  return fetchLevel(map, probe, hit.direction, level);
}
