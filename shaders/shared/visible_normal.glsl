// Samples the lobe of a rough surface: half vectors of GGX visible from V, by spherical caps (Dupuy and Benyoub 2023,
// "Sampling Visible GGX Normals with Spherical Caps"): stretched to roughness 1, reflected directions fill a cap of the
// sphere uniformly. Needs shared/footprint.glsl for the lobe's frame.

LobeSample lobeSample(FootprintLobe lobe, vec2 u)
{
  float phi = 6.2831853f * u.x;
  float height = u.y * (1.0f + lobe.stretched.z);  // from the cap's middle down to its rim
  float radius = sqrt(height * max(2.0f - height, 0.0f));
  vec3 c = vec3(radius * cos(phi) + lobe.stretched.x, radius * sin(phi), max(1.0f - height + lobe.stretched.z, 0.0f));
  vec3 h = vec3(lobe.alpha * c.x, lobe.alpha * c.y, c.z);
  float h2 = max(dot(h, h), 1.0e-18f);
  vec3 l = 2.0f * dot(lobe.view, h) / h2 * h - lobe.view;

  LobeSample result;
  float a2 = lobe.alpha * lobe.alpha;
  float maskLight = sqrt(a2 + (1.0f - a2) * l.z * l.z);
  // G2 / G1, height-correlated Smith. Below the surface there is nothing.
  result.weight = l.z > 0.0f ? l.z * (lobe.view.z + lobe.maskView) / (lobe.view.z * maskLight + l.z * lobe.maskView) : 0.0f;
  result.direction = normalize(lobe.tangent * l.x + lobe.bitangent * l.y + lobe.normal * l.z);
  // Steradian: 1 / density of the directions = 2 pi (NV + sqrt(alpha² + (1 - alpha²) NV²)) alpha² |c|⁴ / |h|⁴.
  float q = dot(c, c) / h2;
  result.solidAngle = 6.2831853f * (lobe.view.z + lobe.maskView) * a2 * q * q;
  return result;
}

// The same for a given unit direction.
LobeSample lobeTowards(FootprintLobe lobe, vec3 direction)
{
  vec3 l = vec3(dot(lobe.tangent, direction), dot(lobe.bitangent, direction), dot(lobe.normal, direction));
  vec3 h = l + lobe.view;
  float a2 = lobe.alpha * lobe.alpha;
  float maskLight = sqrt(a2 + (1.0f - a2) * l.z * l.z);
  LobeSample result;
  result.weight = l.z > 0.0f ? l.z * (lobe.view.z + lobe.maskView) / (lobe.view.z * maskLight + l.z * lobe.maskView) : 0.0f;
  result.direction = direction;
  // D(h) = alpha² / (pi q²) for the unit half vector, without the difference of squares that cancels at small alpha.
  float q = (h.x * h.x + h.y * h.y + a2 * h.z * h.z) / max(dot(h, h), 1.0e-18f);
  result.solidAngle = 6.2831853f * (lobe.view.z + lobe.maskView) * q * q / a2;
  return result;
}
