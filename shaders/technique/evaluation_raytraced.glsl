// The lobe by ray tracing against the projection: half vectors drawn as they are visible from the eye, each mirrored ray
// projected and looked up, G2 / G1 its weight. What the other evaluations approximate; noisy or with ghosts of small lamps where
// the samples are too few. Each is looked up in
//   level 0           as published: what the capture shows there, and nothing of what lies between two samples
//   levelOffset       a level that grows with the distance d of the hit as HDRP's form has it: that of a lobe of d / |H - C| times
//                     the share of alpha that falls to one sample
//   filtered          the level of the patch of wall that the sample stands for, by its own solid angle
// The factors in front are fits (tests/bench/fit_raytraced).

// So narrow a lobe that it lies within one texel of any capture: one lookup, exact.
const float kMirrorRoughness = 1.0e-3f;
// From here on the samples' own weights are their norm. Fewer scatter too much for that, and with one the weight would cancel.
const int kFewSamples = 8;

float sampleLevel(ProbeShape probe, ProbeHit hit, LobeSample s, float alphaEach, float count)
{
  if (probe.parameters.filtered == 1)
  {
    // A lobe of that solid angle at its peak has alpha² = solid angle / (4 pi); times a factor, fitted, as is the bias.
    float size = 1.5f * 0.0795775f * s.solidAngle / count;
    return footprintLevel(probe, size * footprintScale(probe, hit, s.direction), -0.5f);
  }
  if (probe.parameters.levelOffset == 1)
  {
    vec3 a = abs(hit.direction);
    float largest = max(max(a.x, a.y), max(a.z, 1.0e-37f));
    float seenFrom = largest * length(hit.direction / largest);
    float ratio = hit.distance < seenFrom ? hit.distance / seenFrom : 1.0f;
    return levelForAlpha(ratio * alphaEach, probe.maxLevel);
  }
  return 0.0f;
}

vec4 evaluateRaytraced(PROBE_MAP map, ProbeShape probe, ShadingPoint point)
{
  if (point.roughness < kMirrorRoughness)
  {
    ProbeHit mirrored = projectRay(probe, point.position, point.normal, point.reflection);
    return fetchProbe(map, probe, mirrored.direction, 0.0f);
  }
  int count = int(clamp(probe.parameters.samples, 1.0f, 256.0f));
  float number = float(count);
  FootprintLobe lobe = footprintLobe(point, 1.0f);
  float alphaEach = min(1.6f * lobe.alpha / sqrt(number), 1.0f);
  SamplePattern pattern = samplePattern(point, probe.parameters.pattern, count);
  vec4 sum = vec4(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < count; ++i)
  {
    LobeSample s = lobeSample(lobe, samplePoint(pattern, i));
    if (s.weight > 0.0f)
    {
      ProbeHit hit = projectRay(probe, point.position, point.normal, s.direction);
      sum = sum + s.weight * fetchProbe(map, probe, hit.direction, sampleLevel(probe, hit, s, alphaEach, number));
      weights = weights + s.weight;
    }
  }
  if (count >= kFewSamples && weights > 0.0f) { return sum / weights; }
  // Divided by the mean of all weights there could be, so that frames average to the integral. What these samples' weights lack is
  // made up for with the lobe's prefiltered mean; were it to be more than all, their own weights are the norm.
  float norm = 1.0f / max(number * lobeAlbedo(lobe), weights);
  return norm * sum + (1.0f - norm * weights) * evaluateFootprint1(map, probe, point);
}
