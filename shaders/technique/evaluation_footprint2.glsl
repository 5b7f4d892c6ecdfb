// Two parts of the lobe, each sampled by the patch of wall it covers; see shared/footprint.glsl. Points, weights and
// factors were fitted to this project's prefilter by tests/bench/fit_footprints.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.219f - 0.264f * a - 0.041f * n;
  lobe.scaleU = 1.0f + 0.000f * a + 0.000f * n;
  lobe.scaleV = 1.0f - 0.547f * a - 0.096f * n;
  lobe.shift = lobe.view.x * (-0.076f + 0.612f * a + 0.175f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (0.904f - 0.360f * a) / (1.0f - 0.368f * a);
  lobe.size = lobe.size * 0.145f * max(1.0f + 2.974f * a + 1.023f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.463f - 0.090f * a, 0.363f - 0.119f * a, 0.719f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.264f + 1.487f * a, 0.637f - 0.249f * a, 1.255f);
  return sum.value / sum.weight;
}
