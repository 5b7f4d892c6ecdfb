// The whole lobe in one lookup: where three of its rays hit, seen from C, says in which direction and in which level; see
// shared/footprint.glsl. Points, weights and factors are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint1(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.045f + 0.249f * a - 0.189f * n;
  lobe.scaleU = 1.0f - 0.086f * a - 0.265f * n;
  lobe.scaleV = 1.0f - 0.785f * a + 0.631f * n;
  lobe.shift = lobe.view.x * (-0.099f + 0.332f * a + 0.077f * n);
  FootprintPatch seen = footprintPatch(probe, point, lobe, 0.0f, -0.440f, 1.002f);
  seen = footprintExtend(probe, point, lobe, seen, 0.842f, 0.220f, 1.0f);
  seen = footprintExtend(probe, point, lobe, seen, -0.842f, 0.220f, 1.0f);
  float narrow = 0.311f - 0.368f * a - 0.035f * n + 0.244f * a * n;
  return footprintMean(map, probe, seen, narrow, 1.196f, lobe.bias);
}
