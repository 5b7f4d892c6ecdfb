// Contact hardening as in Godot's box projection: by distance, q = d / S (1 - f) + (1 - f) p, saturated; level =
// mix(alpha² L, level of p, q). The Fresnel-like f = (1 - N.V)^power makes grazing reflections sharper. Published with S = 6 metres
// (hardeningLength), power 4 and a chain of L = 6. In its place f may be the surface's own Fresnel reflectance, as Godot's alternative
// has it: of a metal that is bright from every side, so metals stay sharp.
vec4 evaluateGodot(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float p = clamp(point.roughness, 0.0f, 1.0f);
  float reach = max(probe.parameters.hardeningLength, 1.0e-30f);
  // A million lengths away q is 1 in every case; the bound keeps d / S, huge without a proxy to hit, from becoming inf * 0.
  float lengths = min(hit.distance, 1.0e6f * reach) / reach;
  float facing = clamp(dot(point.normal, point.view), 0.0f, 1.0f);
  float own = pow(1.0f - facing, max(probe.parameters.power, 1.0e-3f));
  float unfresnel = 1.0f - (probe.parameters.fresnel == 1 ? clamp(point.fresnel, 0.0f, 1.0f) : own);
  float q = clamp(unfresnel * (lengths + p), 0.0f, 1.0f);
  float alpha = p * p;
  return fetchLevel(map, probe, hit.direction, mix(alpha * alpha * probe.maxLevel, levelForCurve(probe, p), q));
}
