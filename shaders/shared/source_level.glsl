// How a level of the source's mip chain is made from the one before: four bilinear lookups per texel, which together are
// the filter 1 3 3 1 along each axis. Repeated from level to level it tends to a quadratic spline: a lookup's footprint
// is then smooth and nearly round, and the footprints of neighbouring lookups add up evenly. The plain mean of 2 x 2
// (glGenerateMipmap) gives square footprints with a hard border, which show as blotches around a lamp; see the table in
// tests/bench/README.md. Needs shared/cube.glsl.

// Coordinate of a lookup, from the texel's centre towards side -1 or 1: between the texel beside the centre, which
// counts three times, and the next.
float sourceLookup(float centre, float side, float faceSize)
{
  return centre + side * 0.75f / faceSize;
}

// The solid angle there relative to the face's middle. Weighed by it, a level keeps the light of the one before however
// far from the middle of a face a lamp is.
float sourceWeight(float s, float t)
{
  float r2 = 1.0f + s * s + t * t;
  return 1.0f / (r2 * sqrt(r2));
}
