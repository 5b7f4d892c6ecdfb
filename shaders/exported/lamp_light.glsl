// Irradiance over pi of a lamp at a surface that sees all of it. World space; the normal unit.
vec3 boxprobeLampDiffuse(BoxprobeLamp lamp, vec3 position, vec3 normal)
{
  return lampDiffuse(lamp, position, normal) * lamp.radiance;
}
