// The lobe by ray tracing against the projection: half vectors drawn as they are visible from the eye, each mirrored ray
// projected and looked up, G2 / G1 times its own microfacet's reflectance its weight. What the other evaluations approximate; noisy or with ghosts of small lamps where
// the samples are too few. Each is looked up in
//   level 0           as published: what the capture shows there, and nothing of what lies between two samples
//   levelOffset       a level that grows with the distance d of the hit as HDRP's form has it: that of a lobe of d / |H - C| times
//                     the share of alpha that falls to one sample
//   filtered          the level of the patch of wall that the sample stands for, by its own solid angle; each sample blurs, so the
//                     rays are drawn from a narrower lobe, and both together are as wide as the surface's
// Of a picture that is a mean of frames `total` says how many rays there will be in all: each is then blurred for that many, and the
// mean of the frames is what one frame of all the rays would show.
// With sampling `luminance` half of the rays are drawn from the lobe and half from the probe's brightness; each counts by how likely
// both ways together were to draw it (the balance heuristic, Veach and Guibas 1995). At level 0 only: a blurred sample finds lamps
// beside it by itself, and would count their light a second time.
// The factors in front are fits.

// So narrow a lobe that it lies within one texel of any capture: one lookup, exact.
const float kMirrorRoughness = 1.0e-3f;
// From here on the samples' own weights are their norm. Fewer scatter too much for that, and with one the weight would cancel.
const int kFewSamples = 8;

// Roughness of the lobe whose `number` blurred samples are together as wide as the lobe of `roughness`. A sample's blur has its share
// of alpha² = roughness⁴, 1 / number times a factor, fitted to random rooms; of one or two samples more must be left than that.
float narrowedRoughness(float roughness, float number)
{
  return roughness * max(1.0f - 0.56f / number, 0.775f);
}

// `solidAngle`: what one of `number` samples stands for.
float sampleLevel(ProbeShape probe, ProbeHit hit, vec3 direction, float alphaEach, float solidAngle, float number)
{
  if (probe.parameters.filtered == 1)
  {
    // A lobe of that solid angle at its peak has alpha² = solid angle / (4 pi); times a factor, fitted, as is the bias. A blur takes light
    // from the brightest part of a lobe, and beyond 64 samples less of it will do.
    float size = min(2.0f + 64.0f / number, 3.0f) * 0.0795775f * solidAngle;
    return footprintLevel(probe, size * footprintScale(probe, hit, direction), -0.5f);
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
  ProbeHit mirrored = projectRay(probe, point.position, point.normal, point.reflection);
  if (point.roughness < kMirrorRoughness) { return fetchProbe(map, probe, mirrored.direction, 0.0f); }
  bool sharp = probe.parameters.filtered == 0 && probe.parameters.levelOffset == 0;
  int lightSize = 0;
  if (probe.parameters.sampling == 1 && sharp && lightAimable(probe, point, mirrored)) { lightSize = probeLightSize(probe); }
  int count = int(clamp(probe.parameters.samples, lightSize > 0 ? 2.0f : 1.0f, 256.0f));  // at least one ray each way
  float number = float(count);
  float inAll = max(number, probe.parameters.total);
  ShadingPoint drawn = point;
  if (probe.parameters.filtered == 1) { drawn.roughness = narrowedRoughness(point.roughness, inAll); }
  FootprintLobe lobe = footprintLobe(drawn, 1.0f);
  float alphaEach = min(1.6f * lobe.alpha / sqrt(inAll), 1.0f);

  // Of an odd number of rays the last goes one way or the other; on average each way has half.
  uint seed = probe.parameters.pattern == 3 ? 0u : pixelHash(point.pixel);
  int fromLobe = lightSize > 0 ? (count + int((seed + uint(point.frame)) & 1u)) / 2 : count;
  float lobeNumber = lightSize > 0 ? 0.5f * number : number;
  float lightNumber = number - lobeNumber;
  SamplePattern lobePattern = samplePattern(point, probe.parameters.pattern, fromLobe);
  SamplePattern lightPattern = lobePattern;
  if (lightSize > 0) { lightPattern = samplePattern(point, probe.parameters.pattern, count - fromLobe); }

  vec4 sum = vec4(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < count; ++i)
  {
    bool aimed = i >= fromLobe;
    vec3 fromC = vec3(0.0f);
    LobeSample s;
    if (aimed)
    {
      uint place = hashed(seed + lightPattern.first + uint(i));
      fromC = lightDirection(probe, samplePoint(lightPattern, i - fromLobe), vec2(unitNumber(place), unitNumber(hashed(place))), lightSize);
      s = lobeTowards(lobe, towardsLight(probe, point.position, fromC, mirrored.face < 0));
    }
    else { s = lobeSample(lobe, samplePoint(lobePattern, i)); }
    if (s.weight > 0.0f)
    {
      ProbeHit hit = projectRay(probe, point.position, point.normal, s.direction);
      float density = lightSize > 0 ? lightDensity(probe, hit, s.direction, lightSize) : 0.0f;
      if (!aimed || (density > 0.0f && lightReached(hit, fromC)))
      {
        // Rays expected per weight of the lobe's own density: of both ways.
        float expected = lobeNumber + lightNumber * density * s.solidAngle;
        float facet = sqrt(max(0.5f + 0.5f * dot(point.view, s.direction), 0.0f));  // V.H
        float share = s.weight * facetReflectance(point.f0, facet, 1.0f) / expected;
        float level = sharp ? 0.0f : sampleLevel(probe, hit, s.direction, alphaEach, s.solidAngle * number / (expected * inAll), inAll);
        sum = sum + share * fetchProbe(map, probe, hit.direction, level);
        weights = weights + share;
      }
    }
  }
  if (inAll > number)
  {
    // A part of the rays of a mean: as below, but by the lobe that was drawn from, and never the own weights, whose quotients would not
    // average to the quotient of all rays.
    vec2 part = splitSumAt(lobe.view.z, drawn.roughness);
    float whole = point.f0 * part.x + part.y;
    return (sum + (whole - weights) * evaluateFootprint1(map, probe, point)) / max(whole, 1.0e-6f);
  }
  if (count >= kFewSamples && weights > 0.0f) { return sum / weights; }
  // Divided by the mean of all weights there could be, so that frames average to the integral.
  vec2 all = splitSumAt(lobe.view.z, point.roughness);
  float albedo = point.f0 * all.x + all.y;
  if (lightSize > 0) { return sum / albedo; }
  // What these samples' weights lack is made up for with the lobe's prefiltered mean, so that even light stays even; were it to be
  // more than all, their own weights are the norm.
  float norm = 1.0f / max(albedo, weights);
  return norm * sum + (1.0f - norm * weights) * evaluateFootprint1(map, probe, point);
}
