// Light through glass: Fresnel and Snell at a surface, and the way through an object by its shell. Needs glass_types.glsl; the host
// supplies fetchGlassShell. `eta` is n1 / n2 with n1 on the side that is looked from, as GLSL's refract wants it. Knows no probe.
//
// Sources: Born and Wolf, Principles of Optics, 1.5 (Fresnel); Walter et al. 2007 (rough refraction, whose small-angle spread
// refractionSpread is); Beer's law as KHR_materials_volume writes it.

// Beyond this a medium is a mirror to single precision; squares of the inverse stay finite.
float safeEta(float eta)
{
  return clamp(eta, 1.0e-6f, 1.0e6f);
}

// Squared cosine on the far side, 1 - eta² (1 - cosine²); negative: totally reflected. In this order it is the cosine's square
// itself at eta 1, however flat the view: the other loses it to rounding, and an index of 1 would mirror at its outline.
float refractedCosine2(float cosine, float eta)
{
  return (1.0f - eta * eta) + eta * eta * (cosine * cosine);
}

// Share that is reflected, unpolarised, of light at `cosine` to the normal.
float dielectricReflectance(float cosine, float eta)
{
  float e = safeEta(eta);
  float c = clamp(cosine, 0.0f, 1.0f);
  float t2 = refractedCosine2(c, e);
  if (t2 < 0.0f) { return 1.0f; }
  float t = sqrt(t2);
  // Both are 0 only at a grazing view of nothing (eta 1), which reflects nothing.
  float s = (e * c - t) / max(e * c + t, 1.0e-20f);
  float p = (c - e * t) / max(c + e * t, 1.0e-20f);
  return clamp(0.5f * (s * s + p * p), 0.0f, 1.0f);
}

// Of a plane sheet: both of its faces and all that is mirrored between them (the geometric series of R).
float sheetReflectance(float reflectance)
{
  return 2.0f * reflectance / (1.0f + reflectance);
}

// Where the view goes on beyond the surface; 0 where it is totally reflected. A normal that faces away from the eye bends nothing.
vec3 refractedView(vec3 normal, vec3 view, float eta)
{
  float e = safeEta(eta);
  float c = dot(normal, view);
  if (!(c > 0.0f)) { return -view; }
  c = min(c, 1.0f);
  float t2 = refractedCosine2(c, e);
  if (t2 < 0.0f) { return vec3(0.0f); }
  vec3 direction = (e * c - sqrt(t2)) * normal - e * view;
  float size = length(direction);
  return size > 1.0e-6f ? direction / size : -view;
}

// How far a normal that is off by a little turns the refracted ray, beside the mirrored one, which turns twice as far: mean of the
// two directions across it. `cosine` on the near side, `far` beyond.
float refractionSpread(float cosine, float far, float eta)
{
  // Near the critical angle it grows without bound, and the lobe is no longer one: 0.1 keeps it within three times the middle's.
  return 0.5f * abs(far - safeEta(eta) * cosine) / sqrt(max(far, 0.1f));
}

// Share of white light left after `distance`, of which `color` is left after `reach`; reach 0: nothing is absorbed.
vec3 glassTransmittance(vec3 color, float reach, float distance)
{
  // A channel of 0 would be 0^0 at the surface itself.
  vec3 c = clamp(color, vec3(1.0e-6f), vec3(1.0f));
  return reach > 0.0f ? pow(c, vec3(min(max(distance, 0.0f) / max(reach, 1.0e-18f), 1.0e4f))) : vec3(1.0f);
}

// Distance from a point within the shell along `direction` to where it is left, and in `xyz` the normal there, outward. A texel of the
// shell is the plane of the surface seen there. The sphere around it all is left too far out, where a plane of the shell lies before
// the point: each step goes back to the plane found there. Of a convex shell the true exit is never passed. The normal is that of the
// plane that was met last, not of the texel it was met in: between two faces the texels' mean belongs to neither.
vec4 shellExit(GLASS_SHELL shell, GlassObject glass, vec3 position, vec3 direction)
{
  const int kSteps = 6;
  vec3 p = position - glass.center;
  float along = dot(p, direction);
  float t = max(sqrt(max(along * along - dot(p, p) + glass.radius * glass.radius, 0.0f)) - along, 0.0f);
  vec3 normal = vec3(0.0f);
  for (int i = 0; i < kSteps; ++i)
  {
    vec4 plane = fetchGlassShell(shell, p + t * direction);
    vec3 n = vec3(plane.x, plane.y, plane.z);
    float rise = dot(n, direction);
    float gap = max(plane.w - dot(n, p), 0.0f);
    // A plane along the ray tells nothing: 1e-4 of its normal's length.
    if (rise > 1.0e-4f && (gap < t * rise || i == 0))
    {
      t = min(gap / rise, t);
      normal = n;
    }
  }
  float size = length(normal);
  return vec4(size > 1.0e-6f ? normal / size : direction, t);
}

// A ray within the object until it is let out: each time it is totally reflected it goes on inside. `alpha` is what the surface has
// scattered it by so far, within.
GlassRay followGlass(GLASS_SHELL shell, GlassObject glass, vec3 position, vec3 direction, float alpha, float roughAlpha)
{
  const int kMost = 4;
  GlassRay ray;
  ray.position = position;
  ray.direction = direction;
  ray.distance = 0.0f;
  ray.alpha = alpha;
  ray.mirrored = 0;
  for (int i = 0; i < kMost; ++i)
  {
    vec4 leave = shellExit(shell, glass, ray.position, ray.direction);
    vec3 normal = vec3(leave.x, leave.y, leave.z);
    ray.position = ray.position + leave.w * ray.direction;
    ray.distance = ray.distance + leave.w;
    float c = min(dot(normal, ray.direction), 1.0f);
    // It has left where it came in, past an edge that the shell has rounded off: nothing bends it.
    if (!(c > 0.0f)) { return ray; }
    float far2 = refractedCosine2(c, safeEta(glass.ior));
    if (far2 > 0.0f || i + 1 == kMost)
    {
      if (far2 > 0.0f)
      {
        float far = sqrt(far2);
        // What was scattered within leaves the wider the flatter it leaves (Snell's law, differentiated).
        float wider = ray.alpha * min(glass.ior * c / max(far, 0.1f), 4.0f);
        float own = roughAlpha * refractionSpread(c, far, glass.ior);
        ray.alpha = min(sqrt(wider * wider + own * own), 1.0f);
        ray.direction = refractedView(-normal, -ray.direction, glass.ior);
      }
      return ray;
    }
    // Mirrored within: a rough surface scatters what it mirrors, too.
    ray.direction = ray.direction - 2.0f * c * normal;
    ray.alpha = min(sqrt(ray.alpha * ray.alpha + roughAlpha * roughAlpha), 1.0f);
    ray.mirrored = ray.mirrored + 1;
  }
  return ray;
}

// What a pixel of glass looks through and, from within, mirrors. `normal` is turned towards the eye; `back`: it is the inside that the
// eye sees; `eye` its distance.
GlassView lookThroughGlass(GLASS_SHELL shell, GlassObject glass, vec3 position, vec3 normal, vec3 view, float roughness, bool back,
                           float eye)
{
  float roughAlpha = roughness * roughness;
  float eta = back ? glass.ior : 1.0f / safeEta(glass.ior);
  float c = clamp(dot(normal, view), 0.0f, 1.0f);
  float far = sqrt(max(refractedCosine2(c, safeEta(eta)), 0.0f));
  float spread = refractionSpread(c, far, eta);

  GlassView seen;
  seen.reflectance = dielectricReflectance(c, eta);
  seen.followed = false;
  seen.through.position = position;
  seen.through.direction = -view;
  seen.through.distance = glass.thickness;
  seen.through.alpha = min(roughAlpha * spread, 1.0f);
  seen.through.mirrored = 0;
  seen.mirrored = seen.through;
  if (glass.sheet)
  {
    // Two faces, one outside the other, rough each for itself: sqrt(2) of one, and magnified by n on the way out.
    float within = dielectricReflectance(c, 1.0f / safeEta(glass.ior));
    seen.reflectance = sheetReflectance(within);
    float inside = sqrt(max(refractedCosine2(c, 1.0f / safeEta(glass.ior)), 0.0f));
    float turned = refractionSpread(inside, c, glass.ior);
    seen.through.alpha = min(1.41421356f * roughAlpha * turned, 1.0f);
    return seen;
  }
  vec3 direction = refractedView(normal, view, eta);
  bool total = dot(direction, direction) == 0.0f;
  if (!total) { seen.through.direction = direction; }
  if (back)
  {
    seen.through.distance = glass.form == 3 || glass.thickness <= 0.0f ? eye : min(eye, glass.thickness);
    if (glass.form == 3)
    {
      vec3 inward = 2.0f * c * normal - view;
      seen.mirrored = followGlass(shell, glass, position, inward, roughAlpha, roughAlpha);
      seen.mirrored.distance = seen.mirrored.distance + eye;
      seen.followed = true;
    }
    return seen;
  }
  if (glass.form == 3 && !total)
  {
    seen.through = followGlass(shell, glass, position, direction, seen.through.alpha, roughAlpha);
    return seen;
  }
  // Published forms bend once. A rough solid scatters at its second face as well: as a sheet does.
  float behind = refractionSpread(far, c, glass.ior);
  seen.through.alpha = min(1.41421356f * roughAlpha * behind, 1.0f);
  return seen;
}

// How far what is looked through lies from the straight view, as an angle: turned, moved aside (in radii of the object), scattered.
// Light that goes straight on shows what is drawn behind, which no cubemap has as sharp.
float glassDeviation(GlassObject glass, GlassRay ray, vec3 position, vec3 view)
{
  vec3 away = ray.position - position;
  vec3 aside = away - dot(away, view) * view;
  return length(ray.direction + view) + length(aside) / max(glass.radius, 1.0e-18f) + ray.alpha;
}
