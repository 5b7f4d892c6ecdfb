// Diffuse light everywhere in a probe's box, derived from its one capture: at each node of a lattice the light that
// arrives from all around, seen through the probe's projection, as nine spherical-harmonic coefficients. What
// shaders/shared/lattice.glsl blends. A capture whose small lamps are left out (filters/core/geometry/scene_lamps) is
// what it is for: a lamp is seen too coarsely from its map. CPU only; knows no VTK.
#pragma once

#include <array>
#include <glm/ext/vector_int3.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/shared/lamp_math.h"

namespace boxprobe {

struct LatticeSettings {
  float spacing = 1.0f;  ///< of the nodes, about, in metreOf() the box, > 0
  float inset = 0.15f;   ///< of the outermost nodes from the walls, in metreOf() the box; at most a quarter of it
  glm::vec3 reachLow{0.0f}, reachHigh{0.0f};  ///< nodes stand so far beyond the box's sides
  int rays = 1024;  ///< a node; fewer, down to an eighth, where there are more nodes than in a room
};

struct DiffuseLattice : shading::LatticeSampler {
  static constexpr int kParts = 7;     ///< texels a node
  static constexpr int kCutParts = 3;  ///< and as many more where ways between nodes are cut
  static constexpr int kMostNodes = 16;

  glm::ivec3 nodes{0};  ///< along each axis of the box, 2 to kMostNodes
  glm::vec3 low{0.0f};  ///< of the first and the last node, probe frame
  glm::vec3 high{0.0f};
  glm::vec3 inset{0.0f};                  ///< from the ends of what it was made for
  glm::vec3 boxLow{0.0f}, boxHigh{0.0f};  ///< the probe's box, probe frame; nodes may stand beyond it
  /// Parts of the nodes one after another: all nodes' first texels, x fastest, then y, then z; then all second ones.
  std::vector<glm::vec4> texels;
  /// In that order, of the ways from a node to the next along x, then y, then z: how much of it is cut; that times
  /// where what cuts it begins; that times where it ends. Empty: all nodes see their neighbours.
  std::vector<glm::vec4> cuts;
  int cutWays = 0;  ///< ways between nodes that are cut, wholly or in part

  bool empty() const { return texels.empty(); }
  glm::vec4 fetchLattice(const glm::vec3& place, int part) const override;
  /// For latticeIrradiance(); good for as long as this is.
  shading::LatticeShape shape() const;
};

/// What the lengths of things in a box are counted in, scene units: 1, and a tenth of its shortest side where that is
/// longer than 10. A side above 100 is in another unit, and counts as 2.5: a model in millimetres has a room of 2,500
/// of them, whose walls are no 0.1 thick.
double metreOf(const glm::vec3& boxSize);

/// Along each axis of a box of that size: from wall to wall, 2 to DiffuseLattice::kMostNodes. A size or spacing that is
/// no number above 0 gives 2.
glm::ivec3 latticeNodes(const glm::vec3& size, float spacing);

/// A capture with levels of plain means: each texel the mean of the two by two below, weighted by their solid angles,
/// down to one texel per face. Premultiplied by coverage as the capture is.
CubeMap plainMeans(const CubeMap& capture);

/// As much of a capture's level 0 as a lattice needs: plain means of at most 128 texels along a face.
CubeMap latticeCapture(const CubeMap& capture);

/// What light of radiance 1 from a unit direction, world axes, adds to a node's nine coefficients.
std::array<float, 9> latticeBasis(const glm::vec3& directionWorld, double solidAngle);

/// `means`: plainMeans() of a capture. `probe`: its box and projection, as techniques use them. Rotations:
/// `mapFromProbe` of the box's axes into the map's, `worldFromProbe` into the world's, whose normals
/// latticeIrradiance() takes. `sky`: plain means of what shows where the capture is not covered, far away and along the
/// world's axes; null: nothing does.
DiffuseLattice makeDiffuseLattice(const CubeMap& means, const shading::ProbeShape& probe,
                                  const glm::mat3& mapFromProbe = glm::mat3(1.0f),
                                  const glm::mat3& worldFromProbe = glm::mat3(1.0f),
                                  const LatticeSettings& settings = {}, const CubeMap* sky = nullptr);

}  // namespace boxprobe
