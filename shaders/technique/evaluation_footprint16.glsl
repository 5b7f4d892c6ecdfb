// Sixteen pieces of the lobe, each fetched by its own footprint; see shared/footprint.glsl. Points, weights and factors are what
// tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 16.0f);
  float a = lobe.alpha;
  lobe.size = lobe.size * (1.471f - 0.025f * a);
  lobe.bias = -0.412f - 0.254f * a;
  lobe.scale = 0.994f - 0.181f * a;
  lobe.shift = -0.011f + 0.117f * a;
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.752f, 0.908f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.486f, 1.076f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.185f, -0.003f, 0.850f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.284f, -0.423f, 0.963f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.548f, 0.238f, 1.046f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.707f, -0.225f, 1.171f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.406f, 0.699f, 1.081f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.893f, 0.331f, 0.809f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.504f, -0.779f, 0.665f);
  return sum.value / sum.weight;
}
