// Four pieces of the lobe, each fetched by its own footprint; see shared/footprint.glsl. Points, weights and factors are what
// tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 4.0f);
  float a = lobe.alpha;
  lobe.size = lobe.size * (1.171f - 0.418f * a);
  lobe.bias = -0.138f - 0.185f * a;
  lobe.scale = 0.961f - 0.087f * a;
  lobe.shift = -0.017f + 0.470f * a;
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.802f, 0.617f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.559f, 1.567f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.528f, -0.196f, 0.785f);
  return sum.value / sum.weight;
}
