// A probe's lattice of diffuse light, as lattice.glsl sees it.

// What the host fetches a lattice by: on the GPU its number among a draw's probes.
#ifndef LATTICE_SLOT
#define LATTICE_SLOT int
#endif

struct LatticeShape
{
  vec3 low;      // of the first node, probe frame
  vec3 perUnit;  // nodes per scene unit along each axis
  vec3 last;     // number of the last node along each axis, at least 1
  float cut;     // 1: surfaces stand between some of its nodes; 0: every node sees its neighbours
  LATTICE_SLOT slot;
};
