// Irradiance over pi from nine spherical-harmonic coefficients, bands 0 to 2. The host has folded the clamped cosine
// and the basis functions' constants into them, which leaves a polynomial in the unit normal.
vec3 shIrradiance(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6, vec3 c7, vec3 c8)
{
  vec3 e = c0 + c1 * n.y + c2 * n.z + c3 * n.x + c4 * (n.x * n.y) + c5 * (n.y * n.z) +
           c6 * (3.0f * n.z * n.z - 1.0f) + c7 * (n.x * n.z) + c8 * (n.x * n.x - n.y * n.y);
  return max(e, vec3(0.0f));
}
