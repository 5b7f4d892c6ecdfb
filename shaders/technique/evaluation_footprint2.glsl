// Two pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint2(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-2.614f, 5.184f, -2.692f, -1.359f),
          vec3(0.729f, -6.882f, 6.059f), vec3(0.344f, 4.429f, -6.073f));
  lobe.size = lobe.size * footprintTurnedSize(axes, size, -0.417f + 0.787f * p.y);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.358f, 0.088f, 2.724f, -2.187f),
          vec3(0.650f, -2.222f, 1.624f), vec3(0.967f, -2.461f, 1.617f));
  float nearer = lobe.alpha * dot(p, vec4(0.047f, 0.010f, 1.435f, -1.288f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.304f, 0.502f, -0.381f, -0.062f),
          vec3(0.113f, -0.782f, 0.710f), vec3(0.194f, -0.515f, 0.152f)),
          footprintConstant(lobe, axes, p, vec4(0.694f, -1.732f, 0.324f, 0.948f),
          vec3(-0.948f, 2.944f, -2.236f), vec3(-0.599f, 2.820f, -2.395f)),
          dot(p, vec4(0.0f)), dot(p, vec4(-0.323f, 0.742f, -0.403f, -0.070f)), nearer);
  return sum.value / sum.weight;
}
