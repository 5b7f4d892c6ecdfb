// Four pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.030f + 0.010f * a - 0.150f * n;
  lobe.scaleU = 1.0f - 0.370f * a - 0.350f * n;
  lobe.scaleV = 1.0f - 0.760f * a + 0.110f * n;
  lobe.shift = lobe.view.x * (0.010f + 0.060f * a + 0.120f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (1.862f - 1.175f * a) / (1.0f - 0.553f * a);
  lobe.size = lobe.size * 0.133f * max(1.0f - 0.000f * a + 0.670f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.701f + 0.920f * a, 0.181f - 0.073f * a, 0.631f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.469f + 2.490f * a, 0.411f - 0.342f * a, 1.537f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.390f + 0.800f * a, -0.161f + 1.860f * a, 0.204f - 0.069f * a, 1.041f);
  return sum.value / sum.weight;
}
