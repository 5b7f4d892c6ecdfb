// The whole lobe in one lookup: the hits of three of its rays, seen from C, determine direction and level; see
// shared/footprint.glsl. Points, weights and factors were fitted to this project's prefilter by
// tests/bench/fit_footprints.
vec4 evaluateFootprint1(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float a = lobe.alpha;
  float n = lobe.view.z;
  lobe.bias = 0.146f + 0.753f * a + 0.519f * n;
  lobe.scaleU = 1.0f - 0.052f * a - 0.208f * n;
  lobe.scaleV = 1.0f - 0.772f * a + 0.403f * n;
  lobe.shift = lobe.view.x * (-0.088f + 0.392f * a + 0.022f * n);
  FootprintPatch seen = footprintPatch(probe, point, lobe, 0.0f, -0.518f, 0.863f);
  seen = footprintExtend(probe, point, lobe, seen, 0.827f, 0.224f, 1.0f);
  seen = footprintExtend(probe, point, lobe, seen, -0.827f, 0.224f, 1.0f);
  float narrow = 0.117f - 0.118f * a - 0.072f * n + 0.070f * a * n;
  return footprintMean(map, probe, seen, narrow, 0.380f, lobe.bias);
}
