// What a surface sees of its lamps, from a lattice of visibilities in a probe's box. Needs lattice_types.glsl and lattice.glsl; the host
// fetches four lamps' shares at a place.

// Where a surface looks the shares up, in numbers of nodes: a third of a node off it, since nodes behind it see nothing. `n`: its unit
// normal, in the frame of the position.
vec3 sightPlace(LatticeShape lattice, vec3 position, vec3 n)
{
  return clamp((position - lattice.low) * lattice.perUnit + 0.35f * n, vec3(0.0f), lattice.last);
}

// What is seen: nodes' shares are multiplied by their say, which is small within things and close to a sheet's other side.
float sightShare(float share, float say)
{
  return min(share / max(say, 0.004f), 1.0f);
}
