// Two pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.189f - 0.203f * a + 0.141f * n;
  lobe.scaleU = 1.0f + 0.000f * a + 0.000f * n;
  lobe.scaleV = 1.0f - 0.526f * a - 0.060f * n;
  lobe.shift = lobe.view.x * (-0.162f + 0.669f * a + 0.246f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (0.904f - 0.551f * a) / (1.0f - 0.582f * a);
  lobe.size = lobe.size * 0.186f * max(1.0f + 2.252f * a + 0.733f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.478f + 0.152f * a, 0.373f - 0.202f * a, 0.538f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.285f + 1.370f * a, 0.627f - 0.380f * a, 1.212f);
  return sum.value / sum.weight;
}
