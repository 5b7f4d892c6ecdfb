// Sixteen pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = -0.395f - 0.313f * a - 0.071f * n;
  lobe.scaleU = 1.0f - 0.353f * a - 0.138f * n;
  lobe.scaleV = 1.0f - 0.054f * a + 0.060f * n;
  lobe.shift = lobe.view.x * (-0.033f + 0.224f * a - 0.003f * n);
  float g = 1.0f - min(point.f0, 1.0f);
  lobe.bias = lobe.bias + g * (0.025f + 0.080f * a);
  lobe.scaleU = lobe.scaleU + g * (-0.001f * a + 0.017f * n);
  lobe.scaleV = lobe.scaleV + g * (-0.022f * a - 0.008f * n);
  lobe.shift = lobe.shift + g * lobe.view.x * (0.035f + 0.017f * a - 0.066f * n);
  lobe.rise = max(1.0f + 0.389f * a - 0.424f * n, 0.1f);
  lobe.shift = lobe.shift - lobe.scaleV * a * (-0.276f - 0.093f * a) / (1.0f + 0.347f * a);
  lobe.size = lobe.size * 0.022f * max(1.0f + 3.766f * a + 4.837f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.689f - 0.120f * a, 0.076f + 0.000f * a, 1.002f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.544f - 0.269f * a, 0.064f + 0.009f * a, 1.018f);
  sum = footprintAddPair(map, probe, point, lobe, sum, -0.328f + 0.181f * a, -0.084f - 0.199f * a, 0.084f - 0.031f * a, 1.350f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.157f + 0.259f * a, -0.429f - 0.087f * a, 0.041f + 0.053f * a, 1.049f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.392f - 0.060f * a, 0.288f - 0.329f * a, 0.084f - 0.016f * a, 1.134f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.793f + 0.093f * a, -0.205f - 0.161f * a, 0.079f + 0.031f * a, 0.977f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.323f + 0.395f * a, 0.791f - 0.451f * a, 0.048f + 0.039f * a, 0.827f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.740f + 0.065f * a, 0.440f - 0.408f * a, 0.048f + 0.046f * a, 0.852f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.472f + 0.058f * a, -0.742f - 0.232f * a, 0.046f + 0.047f * a, 0.813f);
  return sum.value / sum.weight;
}
