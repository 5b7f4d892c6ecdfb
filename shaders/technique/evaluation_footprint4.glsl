// Four pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.071f - 0.125f * a - 0.029f * n;
  lobe.scaleU = 1.0f - 0.278f * a - 0.313f * n;
  lobe.scaleV = 1.0f - 0.824f * a + 0.165f * n;
  lobe.shift = lobe.view.x * (-0.087f + 0.176f * a + 0.158f * n);
  float g = 1.0f - min(point.f0, 1.0f);
  lobe.bias = lobe.bias + g * (0.027f - 0.058f * a);
  lobe.scaleU = lobe.scaleU + g * (-0.005f * a - 0.053f * n);
  lobe.scaleV = lobe.scaleV + g * (0.040f * a + 0.007f * n);
  lobe.shift = lobe.shift + g * lobe.view.x * (0.060f + 0.430f * a - 0.132f * n);
  lobe.rise = max(1.0f - 0.901f * a + 0.159f * n, 0.1f);
  lobe.shift = lobe.shift - lobe.scaleV * a * (1.996f - 1.137f * a) / (1.0f - 0.472f * a);
  lobe.size = lobe.size * 0.069f * max(1.0f + 1.497f * a + 1.405f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.634f + 0.875f * a, 0.163f - 0.042f * a, 0.626f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.435f + 2.690f * a, 0.427f - 0.350f * a, 1.490f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.446f + 0.512f * a, -0.201f + 1.987f * a, 0.205f - 0.040f * a, 0.872f);
  return sum.value / sum.weight;
}
