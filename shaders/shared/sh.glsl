// Irradiance over pi from nine spherical-harmonic coefficients, bands 0 to 2, already convolved with the clamped cosine.
vec3 shIrradiance(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6, vec3 c7, vec3 c8)
{
  vec3 linear = c0 * 0.2820948f + (c1 * n.y + c2 * n.z + c3 * n.x) * 0.4886025f;
  vec3 quadratic = (c4 * (n.x * n.y) + c5 * (n.y * n.z) + c7 * (n.x * n.z)) * 1.0925484f +
                   c6 * (0.3153916f * (3.0f * n.z * n.z - 1.0f)) + c8 * (0.5462742f * (n.x * n.x - n.y * n.y));
  return max(linear + quadratic, vec3(0.0f));
}
