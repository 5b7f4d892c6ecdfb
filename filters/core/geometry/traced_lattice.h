// A probe's lattice of diffuse light whose nodes see what stands in the box: their rays are traced in the scene, where
// makeDiffuseLattice (filters/math/cube/diffuse_lattice.h) has the probe's projection alone. Deterministic; called
// where lattices are derived, on any thread.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/math/cube/diffuse_lattice.h"

namespace boxprobe {

/// What a lattice is traced in. Equal ones give the same lattice.
struct LatticeSurroundings {
  std::shared_ptr<const SightLines> lines;  ///< null: nothing is traced
  glm::dvec3 originWorld{0.0};              ///< where the map was captured
  glm::dmat3 worldFromProbe{1.0};           ///< rotations
  glm::dmat3 mapFromProbe{1.0};
  std::shared_ptr<const SceneLamps> lamps;  ///< of the scene
  std::vector<std::size_t> drawn;           ///< those of them that are drawn as shapes, and left out of the map
  std::shared_ptr<const std::vector<Light>> lights;  ///< those that shine and are not counted with a lamp; may be null
  /// What shines where a ray meets nothing, far away, along the world's axes; null: what the capture shows there.
  std::shared_ptr<const CubeMap> sky;
  bool open = false;  ///< the capture has no sky: it is premultiplied by its coverage
  bool operator==(const LatticeSurroundings& o) const;
};

/// `base`: the lattice by projection, whose nodes and format this has. What the capture origin sees of a ray's end is
/// looked up in `means` (plainMeans() of the capture without lamps), less the sky beside it. A lamp that is drawn is
/// black. What the origin does not see shines, and scatters, by the mean albedo of its material, the light of lamps,
/// light sources and suns that reach it and what the lattice itself has there: light goes from node to node until less
/// than 0.2 % of it changes, at most 32 times; beyond all nodes, under the sky, the sky's light. Nodes within things
/// take the mean of their neighbours. Where surfaces stand between nodes, each lights its own side of them alone
/// (DiffuseLattice::cuts).
DiffuseLattice tracedLattice(const DiffuseLattice& base, const CubeMap& means, const LatticeSurroundings& in,
                             int rays = 1024);

/// How far apart the nodes of such a lattice are to be: `usual`, and half of it where light comes into the box through
/// openings or from something bright that is not drawn as a shape, since it falls steeply beside them. An opening is
/// what some rays of some nodes pass by far, and most do not. `low`, `high`: the box, probe frame. `means`: as above,
/// what brightness is measured by.
float tracedSpacing(const glm::vec3& low, const glm::vec3& high, float usual, const CubeMap& means,
                    const LatticeSurroundings& in);

}  // namespace boxprobe
