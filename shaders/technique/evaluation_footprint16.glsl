// Sixteen pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = -0.240f - 0.500f * a + 0.130f * n;
  lobe.scaleU = 1.0f - 0.290f * a - 0.070f * n;
  lobe.scaleV = 1.0f - 0.130f * a - 0.010f * n;
  lobe.shift = lobe.view.x * (-0.020f + 0.220f * a + 0.020f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (-0.143f - 0.022f * a) / (1.0f + 0.182f * a);
  lobe.size = lobe.size * 0.022f * max(1.0f + 3.630f * a + 1.100f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.747f - 0.180f * a, 0.090f - 0.036f * a, 1.127f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.653f - 0.310f * a, 0.088f - 0.048f * a, 1.030f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.210f + 0.050f * a, 0.043f - 0.090f * a, 0.069f - 0.005f * a, 1.127f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.280f - 0.050f * a, -0.427f - 0.040f * a, 0.072f - 0.004f * a, 1.259f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.440f + 0.180f * a, 0.343f - 0.170f * a, 0.081f - 0.013f * a, 1.041f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.730f + 0.030f * a, -0.127f - 0.250f * a, 0.064f + 0.028f * a, 0.980f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.480f - 0.050f * a, 0.763f - 0.260f * a, 0.053f + 0.014f * a, 0.869f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.900f + 0.240f * a, 0.213f - 0.110f * a, 0.020f + 0.107f * a, 0.835f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.750f - 0.340f * a, -0.597f - 0.310f * a, 0.052f + 0.006f * a, 0.819f);
  return sum.value / sum.weight;
}
