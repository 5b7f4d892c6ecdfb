// Decodes a direction from one float, 12 bits for each of an octahedron's two coordinates: see Relief::farCode in
// filters/math/cube/relief.h.
vec3 reliefDirection(float code)
{
  float row = floor(code / 4096.0f);
  // Codes reach 2^24: adding one half to a code, which a compiler may do first, would be lost.
  float u = (code - 4096.0f * row) / 2048.0f - (1.0f - 0.5f / 2048.0f);
  float v = (row + 0.5f) / 2048.0f - 1.0f;
  float y = 1.0f - abs(u) - abs(v);
  float fold = max(-y, 0.0f);
  return vec3(u + (u < 0.0f ? fold : -fold), y, v + (v < 0.0f ? fold : -fold));
}

// The direction to sample for what is far away along `direction`, from the fourth number of the relief there; the zero
// vector if everything is near.
vec3 reliefFar(float code, vec3 direction)
{
  if (code < -1.5f) { return direction; }
  if (code < -0.5f) { return vec3(0.0f); }
  return reliefDirection(code);
}
