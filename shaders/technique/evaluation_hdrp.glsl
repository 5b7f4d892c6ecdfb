// Contact hardening as in HDRP and Frostbite: the lobe from P meets a patch of wall at distance d, which the cubemap
// sees from |H - C|; from there it subtends d / |H - C| of the angle. p' = clamp(d / |H - C| p, 0, p), reduced for
// rough surfaces, whose lobe is not a narrow cone: mix(p', p, p).
vec4 evaluateHdrp(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);
  float p = clamp(point.roughness, 0.0f, 1.0f);
  // |H - C| scaled by its largest component: no square under- or overflows in tiny or vast boxes.
  vec3 a = abs(hit.direction);
  float largest = max(max(a.x, a.y), max(a.z, 1.0e-37f));
  float seenFrom = largest * length(hit.direction / largest);
  // Compares before dividing: 0 / 0 (P and C both in the wall) and a huge d without a proxy give 1.
  float ratio = hit.distance < seenFrom ? hit.distance / seenFrom : 1.0f;
  return fetchLevel(map, probe, hit.direction, levelForCurve(probe, mix(ratio * p, p, p)));
}
