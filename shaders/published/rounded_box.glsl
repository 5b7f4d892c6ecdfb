// For comparison and teaching only: a box with rounded edges by deciding once, at the sharp box's hit, which edge (a
// cylinder) the ray meets, and then the corner (a sphere), whose root replaces the edge's. Around the capture origin:
// correct only if that is the box's centre. Needs box_max.glsl.
ProbeHit publishedRoundedBox(ProbeShape probe, vec3 position, vec3 reflection)
{
  ProbeHit hit = publishedBoxMax(probe, position, reflection);
  vec3 inner = 0.5f * (probe.boxMax - probe.boxMin) - vec3(probe.bevel);
  vec3 x = position + reflection * hit.distance;
  vec3 side = vec3(x.x < 0.0f ? -1.0f : 1.0f, x.y < 0.0f ? -1.0f : 1.0f, x.z < 0.0f ? -1.0f : 1.0f);
  vec3 beyond = vec3(abs(x.x) > inner.x ? 1.0f : 0.0f, abs(x.y) > inner.y ? 1.0f : 0.0f, abs(x.z) > inner.z ? 1.0f : 0.0f);
  vec3 o = position - side * inner;
  float count = beyond.x + beyond.y + beyond.z;
  // The edge along the remaining axis, then the corner.
  for (int i = 0; i < 2; ++i)
  {
    vec3 m = i == 0 ? (count > 2.5f ? vec3(1.0f, 1.0f, 0.0f) : beyond) : vec3(1.0f);
    if (count < (i == 0 ? 1.5f : 2.5f)) { continue; }
    float a = dot(m * reflection, reflection);
    float b = dot(m * o, reflection);
    float c = dot(m * o, o) - probe.bevel * probe.bevel;
    hit.distance = (-b + sqrt(b * b - a * c)) / a;
  }
  hit.direction = position + reflection * hit.distance;
  return hit;
}
