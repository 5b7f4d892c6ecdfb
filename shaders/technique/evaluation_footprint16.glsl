// Sixteen pieces of the lobe, in pairs along the axis that the capture origin sees longest; see shared/footprint_turned.glsl. The constants
// are what tests/bench/fit_footprints found for this project's prefilter.
vec4 evaluateFootprint16(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  vec3 axes = footprintAxes(probe, point, lobe);
  vec4 p = footprintPowers(point);
  float size = footprintConstant(lobe, axes, p, vec4(-7.935f, 20.183f, -31.778f, 14.631f),
          vec3(-1.775f, 4.533f, -2.545f), vec3(2.116f, -3.076f, 0.046f));
  lobe.size = lobe.size * footprintTurnedSize(axes, size, 0.483f - 0.178f * p.y);
  lobe.shift = lobe.view.x * footprintConstant(lobe, axes, p, vec4(-0.093f, 1.427f, -3.302f, 2.216f),
          vec3(0.006f, 0.373f, -0.361f), vec3(0.055f, -0.899f, 1.011f));
  float nearer = lobe.alpha * dot(p, vec4(-0.063f, 0.618f, -0.988f, 0.470f));
  FootprintSum sum = footprintStart();
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.841f, 0.278f, -2.375f, 1.593f),
          vec3(0.002f, 0.779f, -0.783f), vec3(0.057f, -1.116f, 0.959f)),
          footprintConstant(lobe, axes, p, vec4(0.532f, -3.554f, 7.759f, -4.735f),
          vec3(0.277f, -1.844f, 1.681f), vec3(-0.575f, 1.649f, -1.180f)),
          dot(p, vec4(0.0f)), dot(p, vec4(-0.673f, 7.558f, -18.041f, 11.031f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(-0.088f, -1.220f, 2.700f, -1.429f),
          vec3(-0.023f, 0.155f, -0.256f), vec3(0.261f, -0.190f, -0.040f)),
          footprintConstant(lobe, axes, p, vec4(-1.114f, 5.685f, -8.794f, 4.038f),
          vec3(0.104f, 0.056f, 0.044f), vec3(0.328f, -1.361f, 1.119f)),
          dot(p, vec4(4.102f, -20.550f, 38.522f, -21.801f)), dot(p, vec4(-0.198f, 3.549f, -4.926f, 1.863f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.659f, 2.439f, -5.948f, 3.399f),
          vec3(-0.081f, 1.188f, -1.236f), vec3(0.013f, -0.509f, 0.426f)),
          footprintConstant(lobe, axes, p, vec4(-0.652f, 3.685f, -7.838f, 4.505f),
          vec3(-0.019f, 0.477f, -0.617f), vec3(0.422f, -1.452f, 1.300f)),
          dot(p, vec4(2.709f, -24.506f, 54.109f, -32.034f)), dot(p, vec4(0.626f, -7.378f, 14.912f, -8.247f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.604f, -0.107f, -2.342f, 2.225f),
          vec3(-0.128f, 1.191f, -0.924f), vec3(-0.019f, -0.012f, -0.322f)),
          footprintConstant(lobe, axes, p, vec4(-0.131f, 1.438f, -0.198f, -0.794f),
          vec3(0.876f, -3.720f, 2.931f), vec3(0.194f, -0.078f, -0.191f)),
          dot(p, vec4(2.432f, -13.559f, 26.307f, -14.976f)), dot(p, vec4(-0.159f, 1.963f, -4.716f, 2.917f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(-0.732f, 0.242f, -0.296f, 0.186f),
          vec3(-0.080f, 0.144f, -0.044f), vec3(-0.004f, -0.583f, 0.898f)),
          footprintConstant(lobe, axes, p, vec4(0.030f, -4.042f, 7.982f, -4.047f),
          vec3(-0.029f, 0.093f, 0.029f), vec3(0.098f, 1.596f, -1.842f)),
          dot(p, vec4(2.153f, -23.487f, 54.443f, -32.745f)), dot(p, vec4(0.307f, -4.362f, 9.301f, -5.354f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.415f, 1.430f, -3.107f, 1.480f),
          vec3(0.254f, -0.825f, 0.689f), vec3(-0.337f, 0.167f, 0.133f)),
          footprintConstant(lobe, axes, p, vec4(-0.023f, -2.480f, 4.856f, -2.657f),
          vec3(0.215f, -0.406f, 0.281f), vec3(-0.424f, 1.217f, -0.748f)),
          dot(p, vec4(3.955f, -28.210f, 59.765f, -35.557f)), dot(p, vec4(0.119f, -0.878f, 3.044f, -2.251f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(-0.254f, 1.128f, -2.730f, 1.793f),
          vec3(-0.081f, 1.059f, -0.907f), vec3(-0.212f, 0.442f, -0.232f)),
          footprintConstant(lobe, axes, p, vec4(0.949f, -1.947f, 3.574f, -2.010f),
          vec3(0.123f, -0.947f, 0.698f), vec3(-0.086f, 1.595f, -1.726f)),
          dot(p, vec4(2.758f, -18.086f, 37.236f, -21.377f)), dot(p, vec4(-0.365f, 4.351f, -9.654f, 5.819f)), nearer);
  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,
          footprintConstant(lobe, axes, p, vec4(0.154f, 1.773f, -5.331f, 2.949f),
          vec3(-0.043f, -1.281f, 1.721f), vec3(-1.416f, 0.925f, 0.739f)),
          footprintConstant(lobe, axes, p, vec4(0.032f, -5.361f, 9.253f, -4.460f),
          vec3(-0.027f, 0.770f, -0.917f), vec3(-0.235f, 1.223f, -0.775f)),
          dot(p, vec4(4.072f, -37.186f, 79.857f, -47.039f)), dot(p, vec4(0.087f, -3.256f, 7.376f, -4.375f)), nearer);
  return sum.value / sum.weight;
}
