// Sixteen pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.038f - 0.962f * a + 0.381f * n;
  lobe.scaleU = 1.0f - 0.230f * a + 0.004f * n;
  lobe.scaleV = 1.0f - 0.129f * a + 0.004f * n;
  lobe.shift = lobe.view.x * (-0.041f + 0.253f * a + 0.020f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (-0.122f - 0.000f * a) / (1.0f + 0.003f * a);
  lobe.size = lobe.size * 0.022f * max(1.0f + 5.139f * a - 0.309f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.728f - 0.069f * a, 0.077f - 0.019f * a, 0.899f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.592f - 0.310f * a, 0.086f - 0.032f * a, 1.030f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.178f + 0.049f * a, 0.000f - 0.034f * a, 0.082f - 0.025f * a, 1.389f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.283f - 0.087f * a, -0.413f + 0.010f * a, 0.080f - 0.022f * a, 1.184f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.425f + 0.195f * a, 0.298f - 0.183f * a, 0.066f - 0.003f * a, 0.935f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.655f - 0.027f * a, -0.176f - 0.197f * a, 0.045f + 0.015f * a, 0.728f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.360f - 0.018f * a, 0.772f - 0.274f * a, 0.061f - 0.002f * a, 0.858f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.780f + 0.231f * a, 0.243f - 0.040f * a, 0.032f + 0.056f * a, 0.835f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.618f - 0.192f * a, -0.613f - 0.274f * a, 0.052f + 0.008f * a, 0.889f);
  return sum.value / sum.weight;
}
