// Colours of a thin film on a surface: interference of the reflections at both of its faces (Belcour and Barla 2017, "A
// Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence"), with the constants of
// KHR_materials_iridescence.

// Linear RGB of the spectrum that results from a path `difference` (nanometres) and a phase shift: the CIE's curves as
// Gaussians, whose transforms have closed forms.
vec3 filmSensitivity(float difference, vec3 shift)
{
  float phase = 6.28318531e-9f * difference;
  vec3 place = vec3(1.6810e6f, 1.7953e6f, 2.2084e6f);
  vec3 variance = vec3(4.3278e9f, 9.3046e9f, 6.6121e9f);
  // Height times sqrt(2 pi variance), over the curves' norm 1.0685e-7.
  vec3 height = vec3(0.846590f, 1.000222f, 1.001122f);
  vec3 xyz = vec3(0.0f);
  xyz.x = height.x * cos(place.x * phase + shift.x) * exp2(-1.44269504f * variance.x * phase * phase) +
          0.153868f * cos(2.2399e6f * phase + shift.x) * exp2(-1.44269504f * 4.5282e9f * phase * phase);
  xyz.y = height.y * cos(place.y * phase + shift.y) * exp2(-1.44269504f * variance.y * phase * phase);
  xyz.z = height.z * cos(place.z * phase + shift.z) * exp2(-1.44269504f * variance.z * phase * phase);
  return vec3(dot(xyz, vec3(3.2404542f, -1.5371385f, -0.4985314f)), dot(xyz, vec3(-0.9692660f, 1.8760108f, 0.0415560f)),
              dot(xyz, vec3(0.0556434f, -0.2040259f, 1.0572252f)));
}

float filmF0(float to, float from)
{
  float r = (to - from) / (to + from);
  return r * r;
}

// Reflectance at `cosine` of a film of index `ior` and `thickness` (nanometres) in air, on a base with reflectance
// `base` at normal incidence.
vec3 filmReflectance(vec3 base, float ior, float thickness, float cosine)
{
  // A film of zero thickness has no index.
  float there = clamp(thickness / 0.03f, 0.0f, 1.0f);
  float film = mix(1.0f, ior, there * there * (3.0f - 2.0f * there));
  float within2 = 1.0f - (1.0f - cosine * cosine) / (film * film);
  if (within2 < 0.0f) { return vec3(1.0f); }
  float within = sqrt(within2);
  float edge = pow(1.0f - cosine, 5.0f);
  float edgeWithin = pow(1.0f - within, 5.0f);
  float outer = mix(filmF0(film, 1.0f), 1.0f, edge);
  vec3 root = sqrt(clamp(base, vec3(0.0f), vec3(0.9999f)));
  vec3 baseIor = (vec3(1.0f) + root) / (vec3(1.0f) - root);
  vec3 r = (baseIor - vec3(film)) / (baseIor + vec3(film));
  vec3 inner = mix(r * r, vec3(1.0f), edgeWithin);
  float pi = 3.14159265f;
  float turnedOuter = film < 1.0f ? 0.0f : pi;
  vec3 shift = vec3(turnedOuter) + vec3(baseIor.x < film ? pi : 0.0f, baseIor.y < film ? pi : 0.0f, baseIor.z < film ? pi : 0.0f);
  float difference = 2.0f * film * thickness * within;

  // The series over the number of internal reflections, cut after two.
  vec3 both = clamp(outer * inner, vec3(1.0e-5f), vec3(0.9999f));
  vec3 amplitude = sqrt(both);
  float passed = 1.0f - outer;
  vec3 mean = passed * passed * inner / (vec3(1.0f) - both);
  vec3 sum = vec3(outer) + mean;
  vec3 term = mean - vec3(passed);
  term = term * amplitude;
  sum = sum + 2.0f * term * filmSensitivity(difference, shift);
  term = term * amplitude;
  sum = sum + 2.0f * term * filmSensitivity(2.0f * difference, 2.0f * shift);
  return max(sum, vec3(0.0f));
}

// The reflectance at normal incidence from which Schlick's curve gives `reflectance` at `cosine`.
vec3 filmNormalReflectance(vec3 reflectance, float cosine)
{
  float edge = min(pow(1.0f - cosine, 5.0f), 0.9999f);
  return clamp((reflectance - vec3(edge)) / (1.0f - edge), vec3(0.0f), vec3(1.0f));
}
