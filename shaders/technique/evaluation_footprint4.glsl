// Four pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-6.072f, 15.478f, -18.182f, 6.014f),
          vec3(1.234f, -2.411f, 0.802f), vec3(2.016f, -1.110f, -2.082f));
  lobe.size = lobe.size * footprintTurnedSize(axes, size, 0.716f - 0.536f * p.y);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(0.039f, -0.275f, 0.803f, -0.347f),
          vec3(-0.142f, 0.712f, -0.531f), vec3(-0.139f, -0.261f, 0.661f));
  float nearer = lobe.alpha * dot(p, vec4(0.058f, -0.299f, 1.490f, -1.139f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.380f, -0.886f, 1.789f, -0.807f),
          vec3(0.232f, -0.850f, 0.542f), vec3(-0.338f, 1.114f, -1.064f)),
          footprintConstant(lobe, axes, p, vec4(-0.163f, 0.343f, -2.406f, 2.385f),
          vec3(-0.225f, 1.900f, -1.922f), vec3(-1.032f, 3.386f, -2.390f)),
          dot(p, vec4(0.0f)), dot(p, vec4(0.952f, -0.287f, -3.664f, 3.223f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.833f, -0.104f, -0.389f, -0.484f),
          vec3(-0.085f, 0.540f, -0.182f), vec3(-0.168f, 0.322f, -0.196f)),
          footprintConstant(lobe, axes, p, vec4(-0.147f, 0.168f, 3.142f, -2.778f),
          vec3(0.750f, -3.958f, 3.399f), vec3(0.518f, -1.426f, 0.837f)),
          dot(p, vec4(-0.297f, -5.427f, 13.265f, -8.129f)), dot(p, vec4(-0.970f, 0.354f, 3.563f, -3.179f)), nearer);
  return sum.value / sum.weight;
}
