// Schlick's approximation of Fresnel reflectance between normal incidence and the edge, as VTK's shader has it
// (Schlick 1994).
vec3 schlickFresnel(vec3 f0, vec3 f90, float cosine)
{
  return f0 + (f90 - f0) * pow(1.0f - cosine, 5.0f);
}

// Reflectance at normal incidence relative to grazing incidence, from the means of the colours: the weight of a
// microfacet's light. The bounds keep a lobe's weights from summing to 0.
float relativeF0(vec3 f0, vec3 f90)
{
  return clamp(dot(f0, vec3(1.0f)) / max(dot(f90, vec3(1.0f)), 1.0e-6f), 1.0e-2f, 1.0e2f);
}

// Mean over the three colours: used to smooth sampled reflections.
float meanFresnel(vec3 f0, vec3 f90, float cosine)
{
  return dot(schlickFresnel(f0, f90, cosine), vec3(1.0f / 3.0f));
}
