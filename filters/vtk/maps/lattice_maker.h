// A probe's lattice of diffuse light (filters/math/cube/diffuse_lattice.h), derived from its maps when a draw first
// asks for it: at once, or beside the draws on other threads. Called with the window's context current; knows no scene.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/traced_lattice.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

/// What lattices are derived from beside the maps.
struct LatticeSource {
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};  ///< probe frame
  glm::mat3 mapFromProbe{1.0f}, worldFromProbe{1.0f};
  int projection = 0;              ///< row of the projection table
  bool fewRays = false;            ///< it is derived over and over
  std::vector<LampPolygon> lamps;  ///< those left out: relative to the capture origin, along the map's axes
  LatticeSurroundings traced;      ///< what nodes see besides the capture; without lines: nothing
  std::shared_ptr<const CubeMap>
      sky;  ///< that shows through the capture's openings, along the world's axes; may be null
  bool operator==(const LatticeSource& o) const;
};

enum class LatticeHaste {
  Now,     ///< waits for it
  Beside,  ///< derived on other threads; the last one until it is there
  AsItIs,  ///< the last one, whatever the source: nothing is derived
};

class LatticeMaker {
 public:
  /// Reads the capture back where a lattice is to be derived. Null: none is there yet.
  std::shared_ptr<const DiffuseLattice> of(const CubeTexture& radiance, const CubeTexture& distance,
                                           const LatticeSource& source, LatticeHaste haste);
  /// Is one being derived beside the draws, or ready and not taken?
  bool pending() const { return beside_.valid(); }
  /// Takes it where it is ready, after at most so long: between two frames, so that all of a frame shows the same.
  void take(int milliseconds);

 private:
  using Lattice = std::shared_ptr<const DiffuseLattice>;
  struct Made {
    LatticeSource source;
    Lattice lattice;
  };
  void keep(LatticeSource source, Lattice lattice);
  void takeNow();

  std::vector<Made> made_;  ///< the last ones, the newest first: a capture may leave out the sky that the window shows
  LatticeSource besideSource_;
  std::shared_future<Lattice> beside_;
};

}  // namespace boxprobe
