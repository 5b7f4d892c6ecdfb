// Two pieces of the lobe, each fetched by its own footprint; see shared/footprint.glsl. Points, weights and factors are what
// tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 2.0f);
  float a = lobe.alpha;
  lobe.size = lobe.size * (1.074f - 0.686f * a);
  lobe.bias = -0.111f + 0.130f * a;
  lobe.scale = 1.067f - 0.057f * a;
  lobe.shift = 0.072f - 0.041f * a;
  FootprintSum sum = footprintStart();
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, -0.472f, 0.860f);
  sum = footprintAdd(map, probe, point, lobe, sum, 0.0f, 0.446f, 1.032f);
  return sum.value / sum.weight;
}
