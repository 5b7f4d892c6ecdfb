// Four pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.183f - 0.255f * a + 0.008f * n;
  lobe.scaleU = 1.0f - 0.350f * a - 0.322f * n;
  lobe.scaleV = 1.0f - 0.662f * a + 0.135f * n;
  lobe.shift = lobe.view.x * (-0.088f + 0.167f * a + 0.204f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (2.023f - 0.565f * a) / (1.0f - 0.242f * a);
  lobe.size = lobe.size * 0.081f * max(1.0f + 1.997f * a + 0.802f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.680f + 1.616f * a, 0.190f - 0.014f * a, 0.561f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.505f + 2.417f * a, 0.375f - 0.202f * a, 1.373f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.462f + 0.576f * a, -0.140f + 2.069f * a, 0.217f - 0.013f * a, 0.797f);
  return sum.value / sum.weight;
}
