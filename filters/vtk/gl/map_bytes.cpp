#include "filters/vtk/gl/map_bytes.h"

#include <cstdio>

#include "filters/core/geometry/probe_reach.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

namespace {

constexpr std::size_t kRgba16fBytes = 8, kR32fBytes = 4;
constexpr std::size_t kLatticeTexels = DiffuseLattice::kParts + DiffuseLattice::kCutParts;  // of a node

std::size_t faceTexels(int size) {
  return 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

}  // namespace

std::size_t probeMapsBytes(int faceSize, bool distances) {
  std::size_t bytes = distances ? faceTexels(faceSize) * kR32fBytes : 0;
  for (int level = 0; level < prefilterLevels(faceSize); ++level)
    bytes += faceTexels(faceSize >> level) * kRgba16fBytes;
  return bytes;
}

std::size_t captureScratchBytes(int faceSize) {
  std::size_t bytes = 0;
  for (int size = faceSize; size > 0; size /= 2) bytes += faceTexels(size) * kRgba16fBytes;
  return bytes;
}

std::size_t latticeBytes(const Probe& probe) {
  const Box& influence = probe.influenceBox();
  const ProbeReach reach = influenceReach(probe.box.min, probe.box.max, influence.min, influence.max);
  // As many as it may have, where there is a door: tracedSpacing().
  const double usual = 0.5 * LatticeSettings{}.spacing * metreOf(probe.box.size());
  const auto spacing = static_cast<float>(probe.lattice ? probe.lattice->spacing : usual);
  const glm::ivec3 nodes = latticeNodes(glm::vec3(probe.box.size() + reach.low + reach.high), spacing);
  return static_cast<std::size_t>(nodes.x * nodes.y * nodes.z) * kLatticeTexels * sizeof(glm::vec4);
}

std::size_t latticeAtlasBytes(std::size_t lattices) {
  if (lattices == 0) return 0;
  std::size_t tiles = 1;
  while (tiles < lattices) tiles *= 2;
  constexpr std::size_t kSide = DiffuseLattice::kMostNodes;
  return tiles * kSide * kSide * kSide * kLatticeTexels * kRgba16fBytes;
}

std::string memoryText(std::size_t bytes) {
  const double megabytes = static_cast<double>(bytes) / static_cast<double>(std::size_t{1} << 20);
  char text[32];
  if (megabytes >= 1000.0) {
    std::snprintf(text, sizeof text, "%.1f GB", megabytes / 1024.0);
  } else {
    std::snprintf(text, sizeof text, "%.*f MB", megabytes < 10.0 ? 1 : 0, megabytes);
  }
  return text;
}

}  // namespace boxprobe
