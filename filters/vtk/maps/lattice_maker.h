// A probe's lattice of diffuse light (filters/math/cube/diffuse_lattice.h), derived from its maps when a draw first
// asks for it. Called by the probe pass's uniforms, with the window's context current; knows no scene.
#pragma once

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
  std::vector<LampPolygon> lamps;  ///< those left out: relative to the capture origin, along the map's axes
  LatticeSurroundings traced;      ///< what nodes see besides the capture; without lines: nothing
  bool operator==(const LatticeSource& o) const;
};

class LatticeMaker {
 public:
  /// Reads the capture back. Derived again for another source, but not while a box is `dragged`: it is then that
  /// of the box before.
  std::shared_ptr<const DiffuseLattice> of(const CubeTexture& radiance, const CubeTexture& distance,
                                           const LatticeSource& source, bool dragged);
  /// The last one; null before the first call of of().
  std::shared_ptr<const DiffuseLattice> latest() const { return lattice_; }

 private:
  LatticeSource source_;
  std::shared_ptr<const DiffuseLattice> lattice_;
};

}  // namespace boxprobe
