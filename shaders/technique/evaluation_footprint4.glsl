// Four parts of the lobe, each sampled by the patch of wall it covers; see shared/footprint.glsl. Points, weights and
// factors were fitted to this project's prefilter by tests/bench/fit_footprints.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.053f - 0.207f * a - 0.036f * n;
  lobe.scaleU = 1.0f - 0.266f * a - 0.311f * n;
  lobe.scaleV = 1.0f - 0.826f * a + 0.153f * n;
  lobe.shift = lobe.view.x * (-0.089f + 0.174f * a + 0.167f * n);
  float g = 1.0f - min(point.f0, 1.0f);
  lobe.bias = lobe.bias + g * (0.027f - 0.058f * a);
  lobe.scaleU = lobe.scaleU + g * (-0.005f * a - 0.053f * n);
  lobe.scaleV = lobe.scaleV + g * (0.040f * a + 0.007f * n);
  lobe.shift = lobe.shift + g * lobe.view.x * (0.060f + 0.430f * a - 0.132f * n);
  lobe.rise = max(1.0f - 0.901f * a + 0.159f * n, 0.1f);
  lobe.shift = lobe.shift - lobe.scaleV * a * (2.065f - 1.219f * a) / (1.0f - 0.503f * a);
  lobe.size = lobe.size * 0.070f * max(1.0f + 1.596f * a + 1.447f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.641f + 0.926f * a, 0.163f - 0.055f * a, 0.650f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.437f + 2.764f * a, 0.429f - 0.352f * a, 1.554f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.443f + 0.494f * a, -0.204f + 2.028f * a, 0.204f - 0.048f * a, 0.908f);
  return sum.value / sum.weight;
}
