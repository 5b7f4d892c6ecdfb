// Irradiance over pi at a surface, without lamps: from a lattice of a .glb that `--format glb` wrote. `nodes`: its texels, and those of its
// `cuts` if it has any, one after another along z, linear and clamped to the edge; `count`, `low`, `high`: its `nodes`, `min` and `max`.
// World space; the normal unit.
vec3 boxprobeLattice(sampler3D nodes, BoxprobeProbe boxprobe, vec3 count, vec3 low, vec3 high, bool cuts, vec3 position, vec3 normal)
{
  LatticeShape lattice;
  lattice.low = low;
  lattice.last = count - vec3(1.0f);
  lattice.perUnit = lattice.last / max(high - low, vec3(1.0e-30f));
  lattice.cut = cuts ? 1.0f : 0.0f;
  lattice.slot = 0;
  return latticeIrradiance(nodes, lattice, boxprobeTurned(boxprobe, position - boxprobe.origin), boxprobeTurned(boxprobe, normal), normal);
}
