// Where pieces of a lobe lie: in pairs, opposite each other about its middle and turned along the axis that the capture origin sees
// longest. A round level leaves most out along that axis, so pieces along it gain most.
//
// They aim a little short of their hits: of what a wide piece covers, the near end is what the capture sees most of.
//
// The axes are those of the derivative of the direction seen from C with respect to the point (u, v) of the disk of visible normals, at
// its middle. A pair is the same after half a turn, as an axis is: so nothing jumps as the longer axis turns. Where the middle is seen
// round there is no such axis; patterns are made so that their turning does not show there.
//
// Needs footprint.glsl. Called by technique/evaluation_footprint2.glsl and 4, whose constants tests/bench/fit_footprints finds.

// x, y: cosine and sine of the angle from u to the longer axis; z: the axes' eccentricity, (long² - short²) / (long² + short²), 0 where
// the middle is seen round and 1 where it is a line.
vec3 footprintAxes(ProbeShape probe, ShadingPoint point, FootprintLobe lobe)
{
  // The middle's half vector and ray. Moved along u, the ray turns about the half vector; along v, within the plane of N and V.
  // Both derivatives without their common factor, 2 alpha / dot(h, h).
  float middle = 0.5f * (1.0f + lobe.stretched.z);
  float t2 = 1.0f - middle;
  float t3 = sqrt(1.0f - t2 * t2);
  vec3 h = vec3(lobe.alpha * (lobe.stretched.x * t3 - lobe.stretched.z * t2), 0.0f, lobe.stretched.x * t2 + lobe.stretched.z * t3);
  float vh = dot(lobe.view, h);
  vec3 l = 2.0f * vh / max(dot(h, h), 1.0e-18f) * h - lobe.view;
  l = vec3(l.x, 0.0f, max(l.z, 1.0e-3f));
  vec3 direction = point.normal * l.z + lobe.tangent * l.x;
  vec3 alongU = vh * lobe.bitangent;
  vec3 alongV = (middle / t3) * (point.normal * l.x - lobe.tangent * l.z);

  ProbeHit hit = projectRay(probe, point.position, point.normal, direction);
  vec3 seen = direction;  // the hit from C, in units of its distance from P
  if (hit.distance < kNoHit)
  {
    vec3 a = abs(hit.direction);
    float largest = max(max(a.x, a.y), a.z);
    float t = max(hit.distance, max(1.0e-9f * largest, 1.0e-37f));
    seen = hit.direction / t;
    // The wall's normal, by the same soft choice as in footprintCosines.
    vec3 normal = vec3(0.0f);
    if (hit.refined >= 0.0f)
    {
      vec3 w = vec3(t) / max(hit.slabFactors, vec3(t));
      w = w * w;
      w = w * w;
      normal = vec3(direction.x < 0.0f ? -w.x : w.x, direction.y < 0.0f ? -w.y : w.y, direction.z < 0.0f ? -w.z : w.z);
    }
    else
    {
      normal = seen - (0.5f * probe.boxMin + 0.5f * probe.boxMax) / t;
      normal = normal / max(length(normal), 1.0e-9f);
    }
    float cosine = max(dot(normal, direction), 1.0e-3f);
    alongU = alongU - dot(normal, alongU) / cosine * direction;
    alongV = alongV - dot(normal, alongV) / cosine * direction;
  }
  // What moves the hit away from C or towards it does not turn the direction.
  float square = max(dot(seen, seen), 1.0e-8f);
  alongU = alongU - dot(seen, alongU) / square * seen;
  alongV = alongV - dot(seen, alongV) / square * seen;

  float uu = dot(alongU, alongU);
  float vv = dot(alongV, alongV);
  float size = max(uu + vv, 1.0e-30f);
  float difference = (uu - vv) / size;
  float mixed = 2.0f * dot(alongU, alongV) / size;
  float eccentricity = min(sqrt(difference * difference + mixed * mixed), 1.0f);
  // Half the angle of (difference, mixed). The least keeps a direction where it is seen round.
  vec2 turned = normalize(vec2(eccentricity + abs(difference) + 1.0e-12f, mixed));
  return vec3(difference < 0.0f ? turned.y : turned.x, difference < 0.0f ? turned.x : turned.y, eccentricity);
}

// Powers of the perceptual roughness p. A dot product with four constants is cubic in p, with three quadratic.
vec4 footprintPowers(ShadingPoint point)
{
  float p = clamp(point.roughness, 0.0f, 1.0f);
  return vec4(1.0f, p, p * p, p * p * p);
}

// What a pattern varies by: roughness, and times the axes' eccentricity and N.V, of which a half counts as 0.
float footprintConstant(FootprintLobe lobe, vec3 axes, vec4 powers, vec4 constants, vec3 byAxes, vec3 byView)
{
  vec3 p = vec3(powers.x, powers.y, powers.z);
  return dot(powers, constants) + axes.z * dot(p, byAxes) + (lobe.view.z - 0.5f) * dot(p, byView);
}

// What a piece is of the lobe before each has its own part. `size`: its logarithm, base 2. `narrowing`: the power of the shorter axis
// over the longer that sharpens levels.
float footprintTurnedSize(vec3 axes, float size, float narrowing)
{
  return exp2(size + 0.5f * narrowing * log2((1.01f - axes.z) / (1.0f + axes.z)));
}

// Two pieces, at x along the longer axis and y along the shorter, and opposite. `weight` and `size` are logarithms, base 2.
FootprintSum footprintAddTurned(PROBE_MAP map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, vec3 axes, FootprintSum sum,
                                float x, float y, float weight, float size, float nearer)
{
  float u = axes.x * x - axes.y * y;
  float v = axes.y * x + axes.x * y;
  float share = exp2(weight);
  float part = exp2(size);
  FootprintSum one = footprintAddShort(map, probe, point, lobe, sum, u, v, share, part, nearer);
  return footprintAddShort(map, probe, point, lobe, one, -u, -v, share, part, nearer);
}
