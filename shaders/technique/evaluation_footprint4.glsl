// Four pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint4(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-3.970f, 10.625f, -13.802f, 5.334f),
                                             vec3(1.864f, -2.525f, 0.186f), vec3(1.702f, -0.345f, -2.600f));
  float narrowing = 1.105f + -0.980f * p.y;
  lobe.size = lobe.size * footprintTurnedSize(axes, size, narrowing);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(0.124f, -0.555f, 1.040f, -0.388f),
                                             vec3(-0.224f, 0.955f, -0.702f), vec3(-0.113f, -0.420f, 0.822f));
  float nearer = -lobe.alpha * dot(p, vec4(-0.010f, 0.076f, -1.162f, 0.989f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.228f, -0.120f, 0.650f, -0.293f),
                                             vec3(0.337f, -1.221f, 0.810f), vec3(-0.389f, 1.293f, -1.164f)),
                           footprintConstant(lobe, axes, p, vec4(-0.244f, 0.831f, -3.315f, 2.870f),
                                             vec3(-0.190f, 1.821f, -1.878f), vec3(-1.029f, 3.426f, -2.377f)),
                           dot(p, vec4(0.0f, 0.0f, 0.0f, 0.0f)), dot(p, vec4(-0.122f, -0.288f, -1.592f, 1.362f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.815f, -0.017f, -0.589f, -0.316f),
                                             vec3(-0.073f, 0.538f, -0.199f), vec3(-0.180f, 0.452f, -0.395f)),
                           footprintConstant(lobe, axes, p, vec4(-0.218f, 0.600f, 2.334f, -2.311f),
                                             vec3(0.823f, -4.152f, 3.521f), vec3(0.473f, -1.100f, 0.514f)),
                           dot(p, vec4(-0.246f, -6.497f, 16.028f, -9.916f)), dot(p, vec4(-3.539f, 7.539f, -5.058f, -0.101f)), nearer);
  return sum.value / sum.weight;
}
