#include "filters/vtk/draw/probe_lattice.h"

namespace boxprobe {

namespace {

LatticeSource latticeSource(const DrawState& state, const SceneLamps& lamps, const DrawnProbe& probe) {
  const ProbeGeometry& g = probe.geometry;
  LatticeSource source;
  source.boxMin = g.boxMin;
  source.boxMax = g.boxMax;
  source.reach = influenceReach(g.boxMin, g.boxMax, g.influenceMin, g.influenceMax);
  source.mapFromProbe = glm::mat3(g.mapFromProbe);
  source.worldFromProbe = glm::mat3(g.worldFromProbe);
  // Following rays by distances matters for reflections; for irradiance the box is accurate enough.
  const bool distances = projectionRows()[static_cast<std::size_t>(g.technique.projection)].distances;
  source.projection = distances ? parseTechnique("box")->projection : g.technique.projection;
  const glm::dmat3 worldFromMap = g.worldFromProbe * glm::transpose(g.mapFromProbe);
  for (const std::size_t i : probe.lamps) {
    source.lamps.push_back(lampPolygon(lamps.lamps[i], g.originWorld, worldFromMap));
  }
  if (probe.lattice) source.spacing = static_cast<float>(probe.lattice->spacing);
  source.fewRays = probe.realtime;
  if (probe.open && state.resources.sky && state.resources.sky->openings) {
    source.sky = std::shared_ptr<const CubeMap>(state.resources.sky, &state.resources.sky->openings->reduced);
  }
  // Not if it is derived continuously.
  if (!state.resources.sightLines || probe.realtime) return source;
  auto sky = source.sky;
  if (!sky && probe.seesSky && state.resources.sky && state.resources.sky->openings) {
    sky = std::shared_ptr<const CubeMap>(state.resources.sky, &state.resources.sky->openings->reduced);
  }
  source.traced = {
      state.resources.sightLines,  g.originWorld,  g.worldFromProbe, g.mapFromProbe, state.resources.lamps, probe.lamps,
      state.resources.looseLights, std::move(sky), probe.open};
  return source;
}

// Dragging a handle only changes uniforms, and a draw that only compiles a program needs no lattice.
LatticeHaste haste(const DrawState& state) {
  if (state.pass().dragging) return LatticeHaste::AsItIs;
  const bool picture = state.pass().exposure == kLinearOutput;
  return state.resources.latticesBeside && !picture ? LatticeHaste::Beside : LatticeHaste::Now;
}

}  // namespace

std::shared_ptr<const DiffuseLattice> probeLattice(const DrawState& state, const DrawnProbe& probe) {
  const SceneLamps* lamps = state.resources.lamps.get();
  const ProbeMaps* maps = probe.maps.get();
  if (!probe.shapes || (probe.lattice && !probe.lattice->used) || lamps == nullptr || maps == nullptr ||
      maps->forTheTimeBeing)
    return nullptr;
  auto lattice = maps->lattice.of(maps->radiance, maps->distance, latticeSource(state, *lamps, probe), haste(state));
  // New maps of the probe use the previous lattice until theirs is ready.
  if (lattice)
    probe.latticeBefore = lattice;
  else
    lattice = probe.latticeBefore;
  return lattice && !lattice->empty() ? lattice : nullptr;
}

}  // namespace boxprobe
