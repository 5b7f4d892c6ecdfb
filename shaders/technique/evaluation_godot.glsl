// Contact hardening as in Godot's box projection, by distance: q = saturate(d / S (1 - f) + (1 - f) p); level =
// mix(alpha² L, level of p, q). The Fresnel-like f = (1 - N.V)^power makes grazing reflections sharper. Published with
// S = 6 metres (hardeningLength), power 4 and a chain of L = 6. Alternatively f is the surface's own Fresnel
// reflectance, as in Godot's other form: high at all angles for metals, which therefore stay sharp.
vec4 evaluateGodot(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float p = clamp(point.roughness, 0.0f, 1.0f);
  float reach = max(probe.parameters.hardeningLength, 1.0e-30f);
  // The bound keeps d / S, huge without a proxy, from becoming inf * 0. At a million lengths q is 1 unless the surface
  // is seen edge-on within 1e-6.
  float lengths = min(hit.distance, 1.0e6f * reach) / reach;
  float facing = clamp(dot(point.normal, point.view), 0.0f, 1.0f);
  float k = max(probe.parameters.power, 1.0e-3f);
  // 1 - (1 - f)^k cancels for small f, and the difference matters at many lengths: there it uses the first terms of the
  // binomial series, with an error of 1e-5 at f = 4e-3 and k = 16, far below a level's step.
  float series = k * facing * (1.0f - 0.5f * (k - 1.0f) * facing * (1.0f - (k - 2.0f) / 3.0f * facing));
  float own = facing < 4.0e-3f ? series : 1.0f - pow(1.0f - facing, k);
  float unfresnel = probe.parameters.fresnel == 1 ? 1.0f - clamp(point.fresnel, 0.0f, 1.0f) : own;
  float q = clamp(unfresnel * (lengths + p), 0.0f, 1.0f);
  float alpha = p * p;
  // Rounding may make a mix of two equal numbers slightly larger than both.
  float level = mix(alpha * alpha * probe.maxLevel, levelForCurve(probe, p), q);
  return fetchLevel(map, probe, hit.direction, min(level, probe.maxLevel));
}
