// Sixteen pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-6.995f, 15.244f, -23.101f, 10.403f),
                                             vec3(1.070f, 1.191f, -1.947f), vec3(0.241f, 3.810f, -5.230f));
  float narrowing = 1.511f + -1.146f * p.y;
  lobe.size = lobe.size * footprintTurnedSize(axes, size, narrowing);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.078f, 0.984f, -2.185f, 1.526f),
                                             vec3(0.020f, 0.259f, -0.276f), vec3(0.077f, -0.633f, 0.699f));
  float nearer = -lobe.alpha * dot(p, vec4(0.026f, -0.450f, 0.753f, -0.367f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.816f, 0.038f, -1.422f, 0.942f),
                                             vec3(0.049f, 0.473f, -0.578f), vec3(0.168f, -1.061f, 0.724f)),
                           footprintConstant(lobe, axes, p, vec4(0.601f, -3.448f, 6.765f, -3.951f),
                                             vec3(0.224f, -1.917f, 1.887f), vec3(-0.693f, 2.150f, -1.478f)),
                           dot(p, vec4(0.0f, 0.0f, 0.0f, 0.0f)), dot(p, vec4(-3.615f, 22.157f, -44.644f, 25.066f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.007f, -1.379f, 2.535f, -1.210f),
                                             vec3(-0.093f, 0.438f, -0.471f), vec3(0.149f, 0.039f, -0.124f)),
                           footprintConstant(lobe, axes, p, vec4(-0.900f, 5.537f, -9.752f, 4.960f),
                                             vec3(0.002f, 0.272f, -0.095f), vec3(-0.294f, 0.579f, -0.258f)),
                           dot(p, vec4(4.389f, -23.140f, 45.107f, -25.559f)), dot(p, vec4(-0.758f, 4.664f, -5.506f, 1.660f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.611f, 2.691f, -6.533f, 3.776f),
                                             vec3(-0.140f, 1.180f, -1.137f), vec3(0.091f, -0.563f, 0.373f)),
                           footprintConstant(lobe, axes, p, vec4(-0.648f, 3.020f, -6.752f, 4.081f),
                                             vec3(-0.143f, 1.203f, -1.221f), vec3(0.429f, -1.477f, 1.297f)),
                           dot(p, vec4(3.394f, -27.744f, 58.122f, -33.027f)), dot(p, vec4(-0.642f, -8.786f, 21.526f, -12.756f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.415f, 0.228f, -1.475f, 1.157f),
                                             vec3(0.089f, 0.223f, -0.195f), vec3(0.387f, -1.434f, 0.855f)),
                           footprintConstant(lobe, axes, p, vec4(0.164f, 0.239f, 1.326f, -1.411f),
                                             vec3(0.633f, -2.986f, 2.455f), vec3(-0.058f, 0.338f, -0.341f)),
                           dot(p, vec4(3.832f, -17.324f, 27.988f, -13.676f)), dot(p, vec4(0.753f, -0.114f, -7.816f, 7.037f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(-0.629f, -0.680f, 1.079f, -0.360f),
                                             vec3(-0.200f, 0.714f, -0.504f), vec3(0.344f, -1.321f, 1.287f)),
                           footprintConstant(lobe, axes, p, vec4(-0.693f, -0.282f, 2.618f, -1.753f),
                                             vec3(0.486f, -1.583f, 1.225f), vec3(-0.045f, 1.483f, -1.523f)),
                           dot(p, vec4(0.674f, -13.315f, 36.205f, -22.600f)), dot(p, vec4(-0.134f, -6.172f, 14.260f, -8.543f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(0.447f, 0.810f, -1.922f, 0.870f),
                                             vec3(0.189f, -0.535f, 0.465f), vec3(-0.461f, 0.841f, -0.400f)),
                           footprintConstant(lobe, axes, p, vec4(-0.086f, -2.592f, 5.206f, -2.838f),
                                             vec3(0.324f, -0.603f, 0.389f), vec3(-0.275f, 0.996f, -0.631f)),
                           dot(p, vec4(5.542f, -33.474f, 64.518f, -36.130f)), dot(p, vec4(1.832f, -9.401f, 14.565f, -7.436f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(-0.048f, 0.627f, -1.915f, 1.239f),
                                             vec3(-0.178f, 0.799f, -0.520f), vec3(-0.376f, 0.810f, -0.395f)),
                           footprintConstant(lobe, axes, p, vec4(1.030f, -2.402f, 4.129f, -2.171f),
                                             vec3(0.057f, -0.534f, 0.334f), vec3(-0.117f, 1.545f, -1.676f)),
                           dot(p, vec4(3.081f, -19.238f, 38.015f, -20.887f)), dot(p, vec4(-2.101f, 12.433f, -23.574f, 13.134f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
                           footprintConstant(lobe, axes, p, vec4(-0.137f, 2.681f, -6.279f, 3.328f),
                                             vec3(0.293f, -2.400f, 2.570f), vec3(-1.458f, 1.606f, -0.028f)),
                           footprintConstant(lobe, axes, p, vec4(-0.260f, -3.716f, 6.638f, -3.244f),
                                             vec3(0.115f, 0.287f, -0.526f), vec3(-0.415f, 1.366f, -0.663f)),
                           dot(p, vec4(1.980f, -27.203f, 65.582f, -40.622f)), dot(p, vec4(-3.260f, 5.448f, 1.681f, -5.439f)), nearer);
  return sum.value / sum.weight;
}
