// Eight parts of the lobe, each sampled by the patch of wall it covers; see shared/footprint.glsl. Points, weights and
// factors were fitted to this project's prefilter by tests/bench/fit_footprints.
vec4 evaluateFootprint8(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.122f - 0.413f * a + 0.070f * n;
  lobe.scaleU = 1.0f - 0.387f * a - 0.174f * n;
  lobe.scaleV = 1.0f + 0.030f * a + 0.062f * n;
  lobe.shift = lobe.view.x * (-0.065f + 0.263f * a + 0.074f * n);
  float g = 1.0f - min(point.f0, 1.0f);
  lobe.bias = lobe.bias + g * (-0.052f - 0.115f * a);
  lobe.scaleU = lobe.scaleU + g * (-0.006f * a + 0.023f * n);
  lobe.scaleV = lobe.scaleV + g * (-0.058f * a + 0.047f * n);
  lobe.shift = lobe.shift + g * lobe.view.x * (0.067f + 0.213f * a - 0.142f * n);
  lobe.rise = max(1.0f - 0.567f * a - 0.005f * n, 0.1f);
  lobe.shift = lobe.shift - lobe.scaleV * a * (0.798f + 8.285f * a) / (1.0f + 13.812f * a);
  lobe.size = lobe.size * 0.025f * max(1.0f + 4.261f * a + 1.459f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.427f + 0.752f * a, 0.138f + 1.488f * a, 0.869f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.215f + 0.449f * a, 0.199f + 1.560f * a, 1.077f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.639f + 0.273f * a, -0.084f + 0.634f * a, 0.135f + 1.711f * a, 0.847f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.395f + 0.195f * a, -0.692f + 0.834f * a, 0.072f + 1.328f * a, 0.792f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.480f + 0.236f * a, 0.561f + 0.444f * a, 0.124f + 2.343f * a, 1.166f);
  return sum.value / sum.weight;
}
