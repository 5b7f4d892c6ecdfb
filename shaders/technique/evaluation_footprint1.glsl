// The whole lobe in one lookup: where three of its rays hit, seen from C, says in which direction and in which level; see
// shared/footprint.glsl. Points, weights and factors are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint1(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = -0.598f + 1.038f * a + 0.751f * n;
  lobe.scaleU = 1.0f - 0.192f * a - 0.278f * n;
  lobe.scaleV = 1.0f - 1.196f * a + 0.987f * n;
  lobe.shift = lobe.view.x * (-0.202f + 0.225f * a + 0.262f * n);
  FootprintPatch seen = footprintPatch(probe, point, lobe, 0.0f, -0.445f, 0.830f);
  seen = footprintExtend(probe, point, lobe, seen, 1.025f, 0.185f, 1.0f);
  seen = footprintExtend(probe, point, lobe, seen, -1.025f, 0.185f, 1.0f);
  float narrow = 0.206f - 0.100f * a - 0.148f * n + 0.077f * a * n;
  return footprintMean(map, probe, seen, narrow, 0.501f, lobe.bias);
}
