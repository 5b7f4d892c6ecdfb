// Contact hardening as in Godot's box projection: by distance, q = d / S (1 - f) + (1 - f) p, saturated; level =
// mix(alpha² L, level of p, q). The Fresnel-like f = (1 - N.V)^power makes grazing reflections sharper. Published with S = 6 metres
// (hardeningLength), power 4 and a chain of L = 6. In its place f may be the surface's own Fresnel reflectance, as Godot's alternative
// has it: of a metal that is bright from every side, so metals stay sharp.
vec4 evaluateGodot(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float p = clamp(point.roughness, 0.0f, 1.0f);
  float reach = max(probe.parameters.hardeningLength, 1.0e-30f);
  // The bound keeps d / S, huge without a proxy to hit, from becoming inf * 0. At a million lengths q is 1 unless the surface is seen
  // edge-on, within 1e-6 of it.
  float lengths = min(hit.distance, 1.0e6f * reach) / reach;
  float facing = clamp(dot(point.normal, point.view), 0.0f, 1.0f);
  float k = max(probe.parameters.power, 1.0e-3f);
  // 1 - (1 - f)^k cancels where f is small, and many lengths away nothing of it may be lost: there the binomial series' first
  // terms, which leave 1e-5 at f = 4e-3 and k = 16, far below a level's step.
  float series = k * facing * (1.0f - 0.5f * (k - 1.0f) * facing * (1.0f - (k - 2.0f) / 3.0f * facing));
  float own = facing < 4.0e-3f ? series : 1.0f - pow(1.0f - facing, k);
  float unfresnel = probe.parameters.fresnel == 1 ? 1.0f - clamp(point.fresnel, 0.0f, 1.0f) : own;
  float q = clamp(unfresnel * (lengths + p), 0.0f, 1.0f);
  float alpha = p * p;
  // Rounding may take a mix of two equal numbers one step above both.
  float level = mix(alpha * alpha * probe.maxLevel, levelForCurve(probe, p), q);
  return fetchLevel(map, probe, hit.direction, min(level, probe.maxLevel));
}
