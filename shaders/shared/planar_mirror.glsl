// A planar mirror's reflection of moving objects: samples the picture of a mirrored camera (premultiplied colour with
// coverage; height over the mirror's plane times coverage). A smooth, flat mirror needs one fetch. Otherwise the lobe
// is sampled: each ray extends to the height of the object it will meet, and is sampled where the mirrored camera sees
// that place, at the level whose texels match the ray's share of the lobe. So reflections are sharp where an object
// touches the mirror, soften with its height, and stretch at grazing angles. The host supplies fetchMirrorColor and
// fetchMirrorHeight(look, uv, level), transparent black outside the picture.

// Narrower lobes are within a texel of the picture.
const float kMirrorFlat = 1.0e-3f;
// Rays for a rough mirror's lobe: enough that the texels of their lookups overlap.
const int kMirrorRays = 16;
// Minimum cosine between ray and mirror's normal: below it the hit is more than 100 times its height away.
const float kMirrorGrazing = 1.0e-2f;

// Where the mirrored camera sees a place; outside the picture for places behind it.
vec2 mirrorPlace(MirrorLook look, vec3 position)
{
  vec4 p = vec4(position, 1.0f);
  float w = dot(look.toW, p);
  return w > 1.0e-20f ? vec2(dot(look.toU, p) / w, dot(look.toV, p) / w) : vec2(-2.0f, -2.0f);
}

// The level whose texels match, at `met`, a cone of `solidAngle` that starts `distance` away from it.
float mirrorLevel(MirrorLook look, vec3 met, float distance, float solidAngle)
{
  vec3 away = met - look.eye;
  float scale = look.parallel > 0.5f ? 1.0f : length(away);
  float texel = max(look.texelSize * scale, 1.0e-30f);
  float wide = distance / texel;
  return clamp(0.5f * log2(max(solidAngle * wide * wide, 1.0e-6f)), look.sharpLevel, look.maxLevel);
}

// Is a moving object near the range of the lobe, from the mirror to the maximum height? One fetch from a level whose
// texels cover that range: coverage is never negative, so a mean of 0 means none. The loop over rays then has no
// iterations, which software renderers skip, unlike branches.
bool mirrorReaches(MirrorLook look, vec3 position, vec3 reflection, float alpha)
{
  float far = look.farHeight / max(dot(reflection, look.normal), kMirrorGrazing);
  vec3 end = position + far * reflection;
  vec2 first = mirrorPlace(look, position);
  vec2 last = mirrorPlace(look, end);
  if (last.x < -1.5f) { return true; }  // reaches behind the mirrored eye: unknown
  // In texels: half of the way, and three times the lobe's half width, which omits a few thousandths of it.
  vec3 away = end - look.eye;
  float scale = look.parallel > 0.5f ? 1.0f : length(away);
  float lobe = 3.0f * alpha * far / max(look.texelSize * scale, 1.0e-30f);
  float way = 0.5f * length(vec2((last.x - first.x) * look.sizeX, (last.y - first.y) * look.sizeY));
  float level = ceil(log2(max(2.0f * (way + lobe), 1.0f)));
  return level > look.maxLevel || fetchMirrorColor(look, 0.5f * (first + last), level).w > 0.0f;
}

// The relative height of what the reflected ray meets: searched from the farthest inwards, with the whole lobe's width.
float mirrorHeight(MirrorLook look, vec3 position, vec3 reflection, float solidAngle, int steps)
{
  float along = max(dot(reflection, look.normal), kMirrorGrazing);
  float height = 1.0f;
  for (int i = 0; i < steps; ++i)
  {
    float distance = height * look.farHeight / along;
    vec3 met = position + distance * reflection;
    vec4 seen = fetchMirrorHeight(look, mirrorPlace(look, met), mirrorLevel(look, met, distance, solidAngle));
    height = seen.w > 1.0e-3f ? clamp(seen.x / seen.w, 0.0f, 1.0f) : height;
  }
  return height;
}

// The number of rays for a lobe that covers texels of `level`: one if it is within a texel.
int mirrorRays(float level)
{
  return level < 0.25f ? 1 : min(int(6.0f * exp2(level)), kMirrorRays);
}

// Number of fetches in the lookup below.
int mirrorFetches(MirrorLook look, vec3 position, vec3 normal, vec3 view, float roughness)
{
  if (roughness < kMirrorFlat) { return 1.0f - dot(normal, look.normal) < 1.0e-6f ? 1 : 4; }
  vec3 reflection = reflectedView(normal, view);
  float alpha = roughness * roughness;
  if (!mirrorReaches(look, position, reflection, alpha)) { return 1; }
  float solidAngle = 12.5663706f * alpha * alpha;
  float distance = mirrorHeight(look, position, reflection, solidAngle, 3) * look.farHeight / max(dot(reflection, look.normal), kMirrorGrazing);
  return 4 + mirrorRays(mirrorLevel(look, position + distance * reflection, distance, solidAngle));
}

// Premultiplied light and coverage, averaged over the lobe. All relative to the eye, world axes.
vec4 mirroredLight(MirrorLook look, vec3 position, vec3 normal, vec3 view, float roughness)
{
  float bent = 1.0f - dot(normal, look.normal);
  if (roughness < kMirrorFlat && bent < 1.0e-6f) { return fetchMirrorColor(look, mirrorPlace(look, position), look.sharpLevel); }

  vec3 reflection = reflectedView(normal, view);
  float alpha = roughness * roughness;
  // The effective solid angle of GGX: 1 / density at its axis.
  float whole = 12.5663706f * alpha * alpha;
  float along = max(dot(reflection, look.normal), kMirrorGrazing);
  bool flatLobe = roughness < kMirrorFlat;
  int searched = flatLobe || mirrorReaches(look, position, reflection, alpha) ? 3 : 0;
  float height = mirrorHeight(look, position, reflection, whole, searched);
  vec3 middle = position + height * look.farHeight / along * reflection;
  float level = flatLobe ? look.sharpLevel : mirrorLevel(look, middle, height * look.farHeight / along, whole);
  int rays = searched == 0 ? 0 : flatLobe ? 1 : mirrorRays(level);
  if (rays == 1) { return fetchMirrorColor(look, mirrorPlace(look, middle), level); }

  // Visible normals by spherical caps (Dupuy and Benyoub 2023), in the frame of the normal with V in the plane of x and
  // z.
  float nv = clamp(dot(normal, view), 1.0e-4f, 1.0f);
  vec3 side = view - normal * dot(normal, view);
  float s = length(side);
  vec3 tangent = s > 1.0e-4f ? side / s : normalize(cross(normal, abs(normal.y) < 0.9f ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f)));
  vec3 bitangent = cross(normal, tangent);
  vec3 v = vec3(sqrt(1.0f - nv * nv), 0.0f, nv);
  float a2 = alpha * alpha;
  float maskView = sqrt(a2 + (1.0f - a2) * nv * nv);
  vec3 stretched = normalize(vec3(alpha * v.x, 0.0f, nv));
  vec4 sum = vec4(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < rays; ++i)
  {
    // A golden-angle spiral, the same in every pixel: mip levels fill the gaps between rays.
    float turn = 2.39996323f * float(i);
    float cap = (float(i) + 0.5f) / float(rays) * (1.0f + stretched.z);
    float radius = sqrt(cap * max(2.0f - cap, 0.0f));
    vec3 c = vec3(radius * cos(turn) + stretched.x, radius * sin(turn), max(1.0f - cap + stretched.z, 0.0f));
    vec3 h = vec3(alpha * c.x, alpha * c.y, c.z);
    float h2 = max(dot(h, h), 1.0e-18f);
    vec3 l = 2.0f * dot(v, h) / h2 * h - v;
    if (l.z > 0.0f)
    {
      // G2 / G1, height-correlated Smith.
      float maskLight = sqrt(a2 + (1.0f - a2) * l.z * l.z);
      float weight = l.z * (nv + maskView) / (nv * maskLight + l.z * maskView);
      float q = dot(c, c) / h2;
      float solidAngle = 6.2831853f * (nv + maskView) * a2 * q * q / float(rays);
      vec3 direction = normalize(tangent * l.x + bitangent * l.y + normal * l.z);
      float distance = height * look.farHeight / max(dot(direction, look.normal), kMirrorGrazing);
      vec3 met = position + distance * direction;
      sum = sum + weight * fetchMirrorColor(look, mirrorPlace(look, met), mirrorLevel(look, met, distance, solidAngle));
      weights = weights + weight;
    }
  }
  return weights > 0.0f ? sum / weights : vec4(0.0f);
}
