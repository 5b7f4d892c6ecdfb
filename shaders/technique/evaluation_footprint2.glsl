// Two pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = -0.020f + 0.200f * a - 0.090f * n;
  lobe.scaleU = 1.0f + 0.000f * a + 0.000f * n;
  lobe.scaleV = 1.0f - 0.490f * a - 0.110f * n;
  lobe.shift = lobe.view.x * (0.040f + 0.480f * a + 0.040f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (1.167f - 0.839f * a) / (1.0f - 0.634f * a);
  lobe.size = lobe.size * 0.395f * max(1.0f + 0.220f * a + 0.100f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.660f + 0.280f * a, 0.275f - 0.121f * a, 0.670f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.250f + 1.570f * a, 0.725f - 0.513f * a, 1.448f);
  return sum.value / sum.weight;
}
