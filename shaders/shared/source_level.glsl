// A level of the source's mip chain from the previous one: four bilinear lookups per texel, together the filter 1 3 3 1
// along each axis. Repeated over levels it approaches a quadratic spline, so footprints are smooth and nearly round,
// and those of neighbouring lookups add up evenly. The plain mean of 2 x 2 (glGenerateMipmap) gives square footprints
// with hard borders, which appear as blotches around a lamp; see the table in tests/bench/README.md. Needs
// shared/cube.glsl.

// Coordinate of a lookup, from the texel's centre towards side -1 or 1: between the texel beside the centre, which has
// weight 3, and the next.
float sourceLookup(float centre, float side, float faceSize)
{
  return centre + side * 0.75f / faceSize;
}

// The solid angle there relative to the face's middle. As a weight it preserves the light of the previous level,
// wherever on the face a lamp is.
float sourceWeight(float s, float t)
{
  float r2 = 1.0f + s * s + t * t;
  return 1.0f / (r2 * sqrt(r2));
}
