// What lattice.glsl fetches by where the texture goes along with the lattice: texels part after part along z, linear and clamped to the edge.
vec4 fetchLattice(sampler3D nodes, LatticeShape lattice, vec3 place, int part)
{
  vec3 count = lattice.last + vec3(1.0f);
  float parts = lattice.cut > 0.0f ? 10.0f : 7.0f;
  vec3 at = place + vec3(0.5f) + vec3(0.0f, 0.0f, count.z * float(part));
  return textureLod(nodes, at / vec3(count.x, count.y, count.z * parts), 0.0f);
}
