// Brushed surfaces: microfacets whose slopes vary more along one direction than across it (KHR_materials_anisotropy).

// GGX alpha along the direction, and across it.
vec2 anisotropicAlpha(float alpha, float strength)
{
  return vec2(mix(alpha, 1.0f, strength * strength), alpha);
}

// D times height-correlated Smith masking over 4 N.L N.V (Burley 2012, Heitz 2014). `toView` ... `halfway` are in the
// frame of that direction, the one across it and the normal.
float anisotropicLobe(vec3 toView, vec3 toLight, vec3 halfway, vec2 alpha)
{
  vec2 a = max(alpha, vec2(1.0e-4f));
  vec3 stretched = vec3(a.y * halfway.x, a.x * halfway.y, a.x * a.y * halfway.z);
  float size = a.x * a.y / max(dot(stretched, stretched), 1.0e-24f);
  float distribution = a.x * a.y * size * size * 0.31830989f;
  float view = toLight.z * length(vec3(a.x * toView.x, a.y * toView.y, toView.z));
  float light = toView.z * length(vec3(a.x * toLight.x, a.y * toLight.y, toLight.z));
  return distribution * 0.5f / max(view + light, 1.0e-6f);
}

// The normal for the single lookup that represents the streak: bent towards the view across the direction `across`,
// more for strong anisotropy and smooth surfaces (McAuley 2015, "Rendering the World of Far Cry 4").
vec3 anisotropicNormal(vec3 normal, vec3 view, vec3 across, float roughness, float strength)
{
  vec3 towards = cross(cross(across, view), across);
  float keep = 1.0f - strength * (1.0f - roughness);
  vec3 bent = mix(towards, normal, keep * keep * keep * keep);
  float size = length(bent);
  return size > 1.0e-6f ? bent / size : normal;
}
