// Where a probe's coverage is sampled for a light; see coverage.glsl.
struct CoverageLook
{
  vec3 hit;        // from the capture origin to where the way to the light leaves the box, probe frame
  float distance;  // along the way from the surface, scene units
  float level;  // of the chain of plain means of the transmittance
};
