// Eight pieces of the lobe, each looked up by the patch of wall it covers; see shared/footprint.glsl. Points, weights and factors
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint8(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.140f - 0.426f * a + 0.020f * n;
  lobe.scaleU = 1.0f - 0.434f * a - 0.173f * n;
  lobe.scaleV = 1.0f + 0.063f * a + 0.063f * n;
  lobe.shift = lobe.view.x * (-0.082f + 0.282f * a + 0.071f * n);
  lobe.shift = lobe.shift - lobe.scaleV * a * (1.465f + 7.235f * a) / (1.0f + 13.948f * a);
  lobe.size = lobe.size * 0.025f * max(1.0f + 4.234f * a + 1.973f * n, 0.1f);
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.361f + 0.621f * a, 0.158f + 1.622f * a, 0.909f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.304f + 0.298f * a, 0.208f + 1.580f * a, 1.024f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.638f + 0.333f * a, -0.043f + 0.581f * a, 0.133f + 1.740f * a, 0.795f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.388f + 0.288f * a, -0.651f + 0.795f * a, 0.087f + 1.281f * a, 0.770f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.461f + 0.300f * a, 0.609f + 0.361f * a, 0.097f + 2.352f * a, 1.161f);
  return sum.value / sum.weight;
}
