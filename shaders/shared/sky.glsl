// Radiance of a gradient sky: horizon to top above, horizon to ground below, linear in the unit direction's y.
vec3 skyGradient(vec3 direction, vec3 top, vec3 horizon, vec3 ground)
{
  float y = direction.y / max(length(direction), 1.0e-30f);
  return y < 0.0f ? mix(horizon, ground, -y) : mix(horizon, top, y);
}
