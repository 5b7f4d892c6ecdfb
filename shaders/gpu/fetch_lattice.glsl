// Lattices of the draw's probes (shared/lattice.glsl), all in one texture: a node's texels lie one lattice's depth apart.
uniform sampler3D bpLattices;
uniform vec3 bpLatticeTexel;                // 1 / size of the texture
uniform vec3 bpLatticeAt[BP_SLOTS];         // first texel
uniform vec3 bpLatticeLow[BP_SLOTS];
uniform vec3 bpLatticePerUnit[BP_SLOTS];
uniform vec3 bpLatticeLast[BP_SLOTS];       // 0: the probe has no lattice
uniform float bpLatticeCut[BP_SLOTS];

// In steps that a float has anywhere in the texture: light does not depend, in its last bit, on which tile a lattice got.
vec3 bpTexelSteps(vec3 place)
{
  return floor(place * 8192.0f + 0.5f) / 8192.0f;
}

vec4 fetchLattice(int slot, vec3 place, int part)
{
  vec3 texel = bpLatticeAt[slot] + bpTexelSteps(place) + vec3(0.5f);
  texel.z += float(part) * (bpLatticeLast[slot].z + 1.0f);
  return textureLod(bpLattices, texel * bpLatticeTexel, 0.0f);
}

LatticeShape bpLatticeShape(int slot)
{
  LatticeShape lattice;
  lattice.low = bpLatticeLow[slot];
  lattice.perUnit = bpLatticePerUnit[slot];
  lattice.last = bpLatticeLast[slot];
  lattice.cut = bpLatticeCut[slot];
  lattice.slot = slot;
  return lattice;
}
