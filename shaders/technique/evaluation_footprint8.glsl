// Eight pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint8(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-7.036f, 17.983f, -27.582f, 12.837f),
          vec3(-0.548f, 4.995f, -4.675f), vec3(1.659f, -0.176f, -2.603f));
  lobe.size = lobe.size * footprintTurnedSize(axes, size, 1.070f - 0.808f * p.y);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.075f, 1.074f, -1.899f, 1.103f),
          vec3(0.105f, -0.641f, 0.703f), vec3(0.041f, -0.138f, 0.267f));
  float nearer = lobe.alpha * dot(p, vec4(-0.006f, 0.000f, 0.555f, -0.490f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.604f, 2.911f, -6.440f, 3.360f),
          vec3(0.108f, -0.544f, 0.595f), vec3(0.144f, -0.055f, -0.243f)),
          footprintConstant(lobe, axes, p, vec4(0.830f, -3.277f, 4.886f, -2.182f),
          vec3(-0.239f, 0.503f, -0.540f), vec3(-0.727f, 1.805f, -1.235f)),
          dot(p, vec4(0.0f)), dot(p, vec4(-3.612f, 7.810f, -3.287f, -0.969f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(-0.698f, 1.548f, -0.996f, 0.029f),
          vec3(0.841f, -2.635f, 1.861f), vec3(0.303f, -1.095f, 0.916f)),
          footprintConstant(lobe, axes, p, vec4(-0.182f, 1.659f, -1.498f, 0.184f),
          vec3(1.216f, -4.338f, 3.128f), vec3(0.175f, -1.387f, 1.207f)),
          dot(p, vec4(2.564f, 0.614f, -11.090f, 7.561f)), dot(p, vec4(-0.042f, 5.478f, -10.922f, 5.559f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.578f, 1.493f, -3.782f, 2.204f),
          vec3(0.342f, -1.286f, 0.837f), vec3(-0.044f, 0.221f, -0.475f)),
          footprintConstant(lobe, axes, p, vec4(-0.447f, 2.323f, -5.400f, 3.220f),
          vec3(0.345f, -1.305f, 0.856f), vec3(-0.549f, 1.223f, -0.603f)),
          dot(p, vec4(1.743f, 0.436f, -9.905f, 7.471f)), dot(p, vec4(0.025f, -0.422f, 0.880f, -0.636f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(-0.098f, 1.819f, -3.220f, 1.589f),
          vec3(0.687f, -1.129f, 0.608f), vec3(0.236f, -0.082f, -0.100f)),
          footprintConstant(lobe, axes, p, vec4(0.769f, -1.258f, 3.057f, -1.992f),
          vec3(-0.718f, 1.041f, -0.521f), vec3(0.230f, -0.824f, 0.408f)),
          dot(p, vec4(3.215f, -4.968f, -2.043f, 3.455f)), dot(p, vec4(0.145f, 5.028f, -14.991f, 9.947f)), nearer);
  return sum.value / sum.weight;
}
