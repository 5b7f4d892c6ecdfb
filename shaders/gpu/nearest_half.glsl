// Rounds each value to the nearest half float. OpenGL does not define how a half-float target rounds, and software
// renderers truncate, which loses a quarter of a percent of the light over a mip chain. Half floats are stored exactly
// by both.
vec4 nearestHalf(vec4 value)
{
  // Eleven bits from the leading one; below 2^-14 half floats are evenly spaced.
  vec4 unit = exp2(max(floor(log2(max(abs(value), vec4(1.0e-9f)))), vec4(-14.0f)) - 10.0f);
  return min(floor(value / unit + 0.5f) * unit, vec4(65504.0f));
}
