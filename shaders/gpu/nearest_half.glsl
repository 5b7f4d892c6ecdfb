// The half float nearest to each value. OpenGL leaves open how a half-float target rounds, and software renderers cut
// off: over the levels of a mip chain that takes a quarter of a percent of the light. A value that is a half float
// already is stored as it is by either.
vec4 nearestHalf(vec4 value)
{
  // Eleven bits from the leading one on; below 2^-14 half floats are evenly spaced.
  vec4 unit = exp2(max(floor(log2(max(abs(value), vec4(1.0e-9f)))), vec4(-14.0f)) - 10.0f);
  return min(floor(value / unit + 0.5f) * unit, vec4(65504.0f));
}
