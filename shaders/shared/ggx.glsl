// GGX (Trowbridge-Reitz) terms. alpha = perceptual roughness squared.

// Half vector in the frame of the normal (z), for N = V, distributed as D(h) (h.z); u in [0,1)². Forms with a single
// cosine lose digits at small alpha; this one keeps cosine and sine separate: tan²(theta) = alpha² u/(1-u).
vec3 ggxHalfVector(vec2 u, float alpha)
{
  float phi = 6.2831853f * u.x;
  float tangent = alpha * sqrt(u.y / max(1.0f - u.y, 1.0e-7f));
  float cosine = 1.0f / sqrt(1.0f + tangent * tangent);
  return vec3(cosine * tangent * cos(phi), cosine * tangent * sin(phi), cosine);
}

// Normal distribution D(h) for a unit half vector in the frame of the normal. Written with dot(h', h') of the stretched
// vector instead of NH²(alpha²-1)+1, which cancels at small alpha. A unit vector has q >= alpha²; that bound, and 1e-30
// for a mirror, keep D below 1e30 for shorter vectors.
float ggxDistribution(vec3 h, float alpha)
{
  float q = h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z;
  float r = alpha / max(q, max(alpha * alpha, 1.0e-30f));
  return r * r * 0.31830989f;
}

// Smith's masking for one direction, cosine with the normal c > 0: G1 = 2c / (c + sqrt(alpha² + (1-alpha²)c²)).
float ggxMasking(float c, float alpha)
{
  return 2.0f * c / max(c + sqrt(alpha * alpha + (1.0f - alpha * alpha) * c * c), 1.0e-30f);
}
