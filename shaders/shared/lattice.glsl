// Diffuse light from a lattice of nodes in a probe's box: nine spherical-harmonic coefficients at each (sh.glsl), blended along three
// axes. A node is seven texels, 28 numbers: the coefficients in order, three colours each, and 1 if the light is the
// node's own, 0 if it lies within something and has that of its neighbours. Where surfaces stand between nodes, three texels more tell of the
// ways from a node to the next, one each along x, y and z: how much of it is cut (0 to 1), and, times that, where what cuts it begins and
// ends (0 at the node, 1 at the next). Needs lattice_types.glsl and sh.glsl; the host supplies
//   vec4 fetchLattice(LATTICE_SLOT slot, vec3 place, int part)   texel `part` of a node, linear in the place between nodes

// Where a position lies among the nodes, 0 to `last` along each axis. Beyond the outermost nodes theirs counts.
vec3 latticePlace(LatticeShape lattice, vec3 position)
{
  return clamp((position - lattice.low) * lattice.perUnit, vec3(0.0f), lattice.last);
}

// Share of the next of two nodes at `t` of the way to it. A surface between the two hides each from what lies beyond it: before the
// surface the first counts alone, behind it the second. Of a thick thing's ends only one is seen from anywhere, so that what lies
// between them may be a ramp. `lean`: towards the side that the shaded surface faces, since it may be the very one that cuts the way.
float latticeStep(float t, float lean, float cut, float begins, float ends)
{
  if (cut <= 1.0e-3f) { return t; }
  float middle = 0.5f * (begins + ends) / cut;
  float width = max((ends - begins) / cut, 0.04f);
  return mix(t, clamp((t + lean - middle) / width + 0.5f, 0.0f, 1.0f), min(cut, 1.0f));
}

// Where the light of a surface that faces `facing` is looked up: as near to each node as its share of the light shall be. Axis by
// axis, since the fetch of the ways along one of them has them as they are between the nodes chosen so far.
vec3 latticeSeen(LatticeShape lattice, vec3 place, vec3 facing)
{
  vec3 first = min(floor(place), lattice.last - vec3(1.0f));
  vec3 seen = place;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 at = seen;
    at[axis] = first[axis];
    vec4 way = fetchLattice(lattice.slot, at, 7 + axis);
    seen[axis] = first[axis] + latticeStep(place[axis] - first[axis], 0.06f * facing[axis], way.x, way.y, way.z);
  }
  return seen;
}

// Irradiance over pi of a surface at `position` that faces `facing` (unit), probe frame, with the unit normal `n`, world axes.
vec3 latticeIrradiance(LatticeShape lattice, vec3 position, vec3 facing, vec3 n)
{
  vec3 place = latticePlace(lattice, position);
  if (lattice.cut > 0.0f) { place = latticeSeen(lattice, place, facing); }
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

// The weight of the nodes around `position`, probe frame, seen from there or not, whose light is their own.
float latticeKnown(LatticeShape lattice, vec3 position)
{
  return fetchLattice(lattice.slot, latticePlace(lattice, position), 6).w;
}
