// Eight pieces of the lobe, each fetched by its own footprint; see shared/footprint.glsl. Points, weights and factors are what
// tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint8(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 8.0f);
  float a = lobe.alpha;
  lobe.size = lobe.size * (1.064f - 0.064f * a);
  lobe.bias = -0.112f - 0.337f * a;
  lobe.scale = 0.929f - 0.166f * a;
  lobe.shift = 0.048f + 0.107f * a;
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.920f, 0.682f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.491f, 0.838f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.272f, -0.108f, 0.716f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.529f, -0.540f, 0.856f);
  sum = footprintAddPair(map, probe, point, lobe, sum, 0.737f, 0.393f, 1.343f);
  return sum.value / sum.weight;
}
