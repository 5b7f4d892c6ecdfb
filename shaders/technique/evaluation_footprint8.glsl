// Eight pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint8(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-6.074f, 15.048f, -22.230f, 10.205f),
                                             vec3(1.355f, 4.236f, -6.464f), vec3(-0.561f, 5.941f, -6.663f));
  float narrowing = 2.183f + -2.189f * p.y;
  lobe.size = lobe.size * footprintTurnedSize(axes, size, narrowing);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.043f, 0.559f, -1.056f, 0.769f),
                                             vec3(0.073f, -0.308f, 0.334f), vec3(0.052f, -0.299f, 0.396f));
  float nearer = -lobe.alpha * dot(p, vec4(0.029f, -0.212f, -0.120f, 0.246f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.630f, 2.424f, -5.433f, 2.827f),
                                             vec3(0.107f, -0.408f, 0.425f), vec3(0.192f, -0.376f, 0.031f)),
                           footprintConstant(lobe, axes, p, vec4(0.734f, -1.965f, 2.589f, -1.164f),
                                             vec3(-0.162f, -0.160f, 0.126f), vec3(-0.640f, 1.380f, -0.843f)),
                           dot(p, vec4(0.0f, 0.0f, 0.0f, 0.0f)), dot(p, vec4(-4.957f, 0.662f, 18.132f, -14.592f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(-0.415f, 0.405f, 0.236f, -0.290f),
                                             vec3(0.491f, -1.386f, 0.859f), vec3(0.164f, -0.718f, 0.665f)),
                           footprintConstant(lobe, axes, p, vec4(-0.077f, 1.060f, -0.393f, -0.415f),
                                             vec3(1.153f, -4.296f, 3.137f), vec3(0.219f, -1.645f, 1.428f)),
                           dot(p, vec4(3.103f, 1.633f, -15.981f, 10.940f)), dot(p, vec4(1.609f, -6.097f, 7.601f, -3.781f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.438f, 2.009f, -4.414f, 2.425f),
                                             vec3(0.437f, -1.502f, 0.987f), vec3(0.093f, -0.324f, -0.025f)),
                           footprintConstant(lobe, axes, p, vec4(-0.737f, 3.243f, -6.460f, 3.624f),
                                             vec3(0.597f, -1.736f, 1.024f), vec3(-0.190f, -0.058f, 0.367f)),
                           dot(p, vec4(2.428f, 2.378f, -18.488f, 13.464f)), dot(p, vec4(-0.243f, 0.839f, -4.903f, 3.428f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.183f, 0.679f, -1.845f, 1.157f),
                                             vec3(0.353f, -0.053f, -0.225f), vec3(0.100f, 0.288f, -0.416f)),
                           footprintConstant(lobe, axes, p, vec4(0.643f, -1.062f, 2.990f, -1.978f),
                                             vec3(-0.689f, 1.245f, -0.789f), vec3(0.396f, -1.103f, 0.517f)),
                           dot(p, vec4(3.478f, -1.502f, -12.914f, 10.686f)), dot(p, vec4(0.441f, 2.296f, -14.233f, 10.970f)), nearer);
  return sum.value / sum.weight;
}
