// Four pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.136f - 0.266f * a - 0.020f * n;
  lobe.scaleU = 1.0f - 0.308f * a - 0.303f * n;
  lobe.scaleV = 1.0f - 0.657f * a + 0.149f * n;
  lobe.shift = lobe.view.x * (-0.120f + 0.152f * a + 0.299f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (2.219f - 1.355f * a) / (1.0f - 0.583f * a);
  lobe.size = lobe.size * 0.045f * max(1.0f + 4.066f * a + 2.662f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.653f + 1.728f * a, 0.202f - 0.113f * a, 0.675f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.479f + 2.645f * a, 0.376f - 0.290f * a, 1.515f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.514f + 0.377f * a, -0.114f + 2.180f * a, 0.211f - 0.090f * a, 0.833f);
  return sum.value / sum.weight;
}
