// Two pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-1.538f, 0.973f, 2.062f, -2.377f),
                                             vec3(0.356f, -5.823f, 5.953f), vec3(0.393f, 4.292f, -5.958f));
  float narrowing = -0.586f + 1.213f * p.y;
  lobe.size = lobe.size * footprintTurnedSize(axes, size, narrowing);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.363f, 0.129f, 2.665f, -2.170f),
                                             vec3(0.658f, -2.270f, 1.676f), vec3(0.962f, -2.420f, 1.588f));
  float nearer = -lobe.alpha * dot(p, vec4(-0.046f, -0.021f, -1.397f, 1.260f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.302f, 0.505f, -0.360f, -0.081f),
                                             vec3(0.120f, -0.819f, 0.739f), vec3(0.191f, -0.500f, 0.138f)),
                           footprintConstant(lobe, axes, p, vec4(0.695f, -1.715f, 0.149f, 1.096f),
                                             vec3(-0.947f, 2.990f, -2.272f), vec3(-0.604f, 2.855f, -2.414f)),
                           dot(p, vec4(0.0f, 0.0f, 0.0f, 0.0f)), dot(p, vec4(-1.440f, 5.235f, -5.870f, 1.358f)), nearer);
  return sum.value / sum.weight;
}
