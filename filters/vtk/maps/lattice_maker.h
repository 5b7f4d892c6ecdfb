// Derives a probe's lattice of diffuse light (filters/math/cube/diffuse_lattice.h) from its maps when a draw first
// needs it: immediately, or on other threads during draws. Needs the window's context current.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_reach.h"
#include "filters/core/geometry/traced_lattice.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

/// The inputs of lattices besides the maps.
struct LatticeSource {
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};  ///< probe frame
  ProbeReach reach;                      ///< of the nodes, where what is traced has surfaces (probe_reach.h)
  glm::mat3 mapFromProbe{1.0f}, worldFromProbe{1.0f};
  int projection = 0;              ///< index in the projection table
  float spacing = 0.0f;            ///< of the nodes, scene units; 0: as the box and its openings ask for
  bool fewRays = false;            ///< it is derived continuously
  std::vector<LampPolygon> lamps;  ///< those removed from the map: relative to the capture origin, along the map's axes
  LatticeSurroundings traced;      ///< what nodes' rays see besides the capture; without lines: nothing
  std::shared_ptr<const CubeMap> sky;  ///< visible through the capture's openings, along the world's axes; may be null
  bool operator==(const LatticeSource& o) const;
};

/// Of all lattices that this process has derived.
struct LatticeCosts {
  std::size_t lattices = 0, nodes = 0;
  std::size_t bytes = 0;    ///< main memory of their texels
  double cpuSeconds = 0.0;  ///< of all threads meanwhile, whatever else they did
};
LatticeCosts latticeCosts();

enum class LatticeHaste {
  Now,     ///< waits for it
  Beside,  ///< derived on other threads; the previous one until it is ready
  AsItIs,  ///< the previous one, whatever the source: nothing is derived
};

class LatticeMaker {
 public:
  /// Reads the capture back if a lattice has to be derived. Null: none is ready.
  std::shared_ptr<const DiffuseLattice> of(const CubeTexture& radiance, const CubeTexture& distance,
                                           const LatticeSource& source, LatticeHaste haste);
  /// Is one being derived on other threads, or ready but not taken?
  bool pending() const { return beside_.valid(); }
  /// Takes it if it is ready, waiting at most this long: between two frames, so that a whole frame shows the same one.
  void take(int milliseconds);

 private:
  using Lattice = std::shared_ptr<const DiffuseLattice>;
  struct Made {
    LatticeSource source;
    Lattice lattice;
  };
  void keep(LatticeSource source, Lattice lattice);
  void takeNow();

  std::vector<Made> made_;  ///< the newest first: a capture may leave out the sky that the window shows
  LatticeSource besideSource_;
  std::shared_future<Lattice> beside_;
};

}  // namespace boxprobe
