// For comparison and teaching only: a probe's weight as distance inside / blend distance: 0 / 0 on the face of a probe
// without a blend distance.
float publishedInfluence(vec3 position, vec3 influenceMin, vec3 influenceMax, float blendDistance)
{
  vec3 inside = min(position - influenceMin, influenceMax - position);
  vec3 share = clamp(inside / blendDistance, vec3(0.0f), vec3(1.0f));
  return share.x * share.y * share.z;
}
