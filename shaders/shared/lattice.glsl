// Diffuse light from a lattice of nodes in a probe's box: nine spherical-harmonic coefficients at each (sh.glsl), blended along three
// axes. A node is seven texels, 28 numbers: the coefficients in order, three colours each, and 1 if the light is the
// node's own, 0 if it lies within something and has that of its neighbours. Needs lattice_types.glsl and sh.glsl; the host supplies
//   vec4 fetchLattice(LATTICE_SLOT slot, vec3 place, int part)   texel `part` of a node, linear in the place between nodes

// Where a position lies among the nodes, 0 to `last` along each axis. Beyond the outermost nodes theirs counts.
vec3 latticePlace(LatticeShape lattice, vec3 position)
{
  return clamp((position - lattice.low) * lattice.perUnit, vec3(0.0f), lattice.last);
}

// Irradiance over pi of a surface at `position`, probe frame, with the unit normal `n`, world axes.
vec3 latticeIrradiance(LatticeShape lattice, vec3 position, vec3 n)
{
  vec3 place = latticePlace(lattice, position);
  vec4 a = fetchLattice(lattice.slot, place, 0);
  vec4 b = fetchLattice(lattice.slot, place, 1);
  vec4 c = fetchLattice(lattice.slot, place, 2);
  vec4 d = fetchLattice(lattice.slot, place, 3);
  vec4 e = fetchLattice(lattice.slot, place, 4);
  vec4 f = fetchLattice(lattice.slot, place, 5);
  vec4 g = fetchLattice(lattice.slot, place, 6);
  return shIrradiance(n, vec3(a.x, a.y, a.z), vec3(a.w, b.x, b.y), vec3(b.z, b.w, c.x), vec3(c.y, c.z, c.w), vec3(d.x, d.y, d.z),
                      vec3(d.w, e.x, e.y), vec3(e.z, e.w, f.x), vec3(f.y, f.z, f.w), vec3(g.x, g.y, g.z));
}

// The weight of the nodes around `position`, probe frame, whose light is their own.
float latticeKnown(LatticeShape lattice, vec3 position)
{
  return fetchLattice(lattice.slot, latticePlace(lattice, position), 6).w;
}
