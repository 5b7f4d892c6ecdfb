// Sixteen parts of the lobe, each sampled by the patch of wall it covers; see shared/footprint.glsl. Points, weights
// and factors were fitted to this project's prefilter by tests/bench/fit_footprints.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = -0.233f - 0.987f * a + 0.559f * n;
  lobe.scaleU = 1.0f - 0.417f * a - 0.167f * n;
  lobe.scaleV = 1.0f - 0.172f * a + 0.104f * n;
  lobe.shift = lobe.view.x * (-0.046f + 0.180f * a + 0.032f * n);
  float g = 1.0f - min(point.f0, 1.0f);
  lobe.bias = lobe.bias + g * (0.016f - 0.042f * a);
  lobe.scaleU = lobe.scaleU + g * (0.019f * a - 0.004f * n);
  lobe.scaleV = lobe.scaleV + g * (0.064f * a + 0.009f * n);
  lobe.shift = lobe.shift + g * lobe.view.x * (-0.023f + 0.145f * a + 0.029f * n);
  lobe.rise = max(1.0f + 0.043f * a - 0.719f * n, 0.1f);
  lobe.shift = lobe.shift - lobe.scaleV * a * (-0.117f + 0.003f * a) / (1.0f - 0.132f * a);
  lobe.size = lobe.size * 0.022f * max(1.0f + 7.835f * a - 0.456f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.668f - 0.036f * a, 0.084f - 0.031f * a, 0.994f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.558f - 0.082f * a, 0.064f - 0.015f * a, 1.017f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.383f - 0.200f * a, -0.069f - 0.036f * a, 0.087f - 0.039f * a, 1.239f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.126f + 0.355f * a, -0.384f - 0.041f * a, 0.040f + 0.013f * a, 0.929f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.394f + 0.055f * a, 0.293f - 0.089f * a, 0.083f - 0.035f * a, 1.015f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.785f + 0.232f * a, -0.230f - 0.039f * a, 0.077f - 0.004f * a, 1.022f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.408f + 0.273f * a, 0.732f - 0.195f * a, 0.057f - 0.004f * a, 0.864f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.839f + 0.242f * a, 0.348f - 0.205f * a, 0.040f + 0.013f * a, 0.823f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.459f + 0.136f * a, -0.733f - 0.158f * a, 0.042f + 0.013f * a, 0.799f);
  return sum.value / sum.weight;
}
