// Light through glass: Fresnel and Snell at a surface, and the path through an object by its shell. Needs
// glass_types.glsl; the host supplies fetchGlassShell. `eta` is n1 / n2 with n1 on the viewer's side, as for GLSL's
// refract.
//
// Sources: Born and Wolf, Principles of Optics, 1.5 (Fresnel); Walter et al. 2007 (rough refraction, whose small-angle spread
// refractionSpread is); Beer's law as KHR_materials_volume writes it.

// Beyond this a medium is a mirror in single precision; squares of the inverse stay finite.
float safeEta(float eta)
{
  return clamp(eta, 1.0e-6f, 1.0e6f);
}

// Squared cosine on the far side, 1 - eta² (1 - cosine²); negative: total reflection. In this order it is exactly the
// squared cosine for eta 1 at any angle; in the other order rounding would make an index of 1 reflect at its outline.
float refractedCosine2(float cosine, float eta)
{
  return (1.0f - eta * eta) + eta * eta * (cosine * cosine);
}

// Unpolarised reflectance at `cosine` to the normal.
float dielectricReflectance(float cosine, float eta)
{
  float e = safeEta(eta);
  float c = clamp(cosine, 0.0f, 1.0f);
  float t2 = refractedCosine2(c, e);
  if (t2 < 0.0f) { return 1.0f; }
  float t = sqrt(t2);
  // Both are 0 only at grazing incidence with eta 1, which reflects nothing.
  float s = (e * c - t) / max(e * c + t, 1.0e-20f);
  float p = (c - e * t) / max(c + e * t, 1.0e-20f);
  return clamp(0.5f * (s * s + p * p), 0.0f, 1.0f);
}

// Reflectance of a plane sheet: both of its faces and all internal reflections (the geometric series of R).
float sheetReflectance(float reflectance)
{
  return 2.0f * reflectance / (1.0f + reflectance);
}

// The refracted view; 0 for total reflection. A normal that faces away from the eye does not refract.
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

// The deflection of the refracted ray by a small deviation of the normal, relative to that of the reflected ray, which
// is twice the deviation: mean of the two directions across it. `cosine` on the near side, `far` on the far side.
float refractionSpread(float cosine, float far, float eta)
{
  // Near the critical angle it diverges, and the lobe is no longer a lobe: 0.1 keeps it within three times that at the
  // axis.
  return 0.5f * abs(far - safeEta(eta) * cosine) / sqrt(max(far, 0.1f));
}

// Transmittance after `distance` for a medium that leaves `color` after `reach`; reach 0: no absorption.
vec3 glassTransmittance(vec3 color, float reach, float distance)
{
  // A channel of 0 would give 0^0 at the surface itself.
  vec3 c = clamp(color, vec3(1.0e-6f), vec3(1.0f));
  return reach > 0.0f ? pow(c, vec3(min(max(distance, 0.0f) / max(reach, 1.0e-18f), 1.0e4f))) : vec3(1.0f);
}

// Distance from a point inside the shell along `direction` to the exit, and in `xyz` the outward normal there. A texel
// of the shell is the plane of the surface seen there. Starts at the bounding sphere, beyond the exit; each step goes
// back to the plane found at the current point. For a convex shell it never passes the true exit. The normal is that of
// the last plane, not of the texel: between two faces interpolated texels match neither.
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
    // A plane parallel to the ray gives no exit: below 1e-4 of its normal's length.
    if (rise > 1.0e-4f && (gap < t * rise || i == 0))
    {
      t = min(gap / rise, t);
      normal = n;
    }
  }
  float size = length(normal);
  return vec4(size > 1.0e-6f ? normal / size : direction, t);
}

// Follows a ray inside the object until it exits; total reflection keeps it inside. `alpha`: the surface's scattering
// so far, inside.
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
    // It has left where it entered, past an edge that the shell has rounded off: no refraction.
    if (!(c > 0.0f)) { return ray; }
    float far2 = refractedCosine2(c, safeEta(glass.ior));
    if (far2 > 0.0f || i + 1 == kMost)
    {
      if (far2 > 0.0f)
      {
        float far = sqrt(far2);
        // Scattering inside widens at flat exit angles (derivative of Snell's law).
        float wider = ray.alpha * min(glass.ior * c / max(far, 0.1f), 4.0f);
        float own = roughAlpha * refractionSpread(c, far, glass.ior);
        ray.alpha = min(sqrt(wider * wider + own * own), 1.0f);
        ray.direction = refractedView(-normal, -ray.direction, glass.ior);
      }
      return ray;
    }
    // Internal reflection: a rough surface also scatters the reflection.
    ray.direction = ray.direction - 2.0f * c * normal;
    ray.alpha = min(sqrt(ray.alpha * ray.alpha + roughAlpha * roughAlpha), 1.0f);
    ray.mirrored = ray.mirrored + 1;
  }
  return ray;
}

// The transmitted view of a pixel of glass and, from inside, the reflected one. `normal` points towards the eye;
// `back`: the eye sees the inner side; `eye`: its distance.
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
    // Two rough faces, one behind the other: sqrt(2) times one, and magnified by n on exit.
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
  // Published forms refract once. A rough solid also scatters at its second face, as a sheet does.
  float behind = refractionSpread(far, c, glass.ior);
  seen.through.alpha = min(1.41421356f * roughAlpha * behind, 1.0f);
  return seen;
}

// The deviation of the transmitted light from the straight view, as an angle: refraction, displacement (in radii of the
// object), scattering. Straight light shows the frame behind, which is sharper than any cubemap.
float glassDeviation(GlassObject glass, GlassRay ray, vec3 position, vec3 view)
{
  vec3 away = ray.position - position;
  vec3 aside = away - dot(away, view) * view;
  return length(ray.direction + view) + length(aside) / max(glass.radius, 1.0e-18f) + ray.alpha;
}
