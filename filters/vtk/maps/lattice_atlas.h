// The lattices of all probes in one three-dimensional texture: one sampler, however many probes a draw has. Needs the
// window's context current.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "filters/math/cube/diffuse_lattice.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class LatticeAtlas {
 public:
  LatticeAtlas() = default;
  ~LatticeAtlas() { release(); }
  LatticeAtlas(const LatticeAtlas&) = delete;
  LatticeAtlas& operator=(const LatticeAtlas&) = delete;

  /// The texel where the lattice begins; uploads the lattice if necessary. Tiles of deleted lattices are reused; the
  /// texture grows if none is free.
  glm::vec3 place(const std::shared_ptr<const DiffuseLattice>& lattice);
  /// RGBA16F, linear filtering; 0 before the first call of place().
  GLuint handle() const { return handle_; }
  /// 1 / its size in texels along each axis.
  glm::vec3 texelSize() const;
  void release();

 private:
  void grow();
  void fillWithNothing() const;
  void upload(std::size_t tile) const;
  glm::ivec3 first(std::size_t tile) const;

  GLuint handle_ = 0;
  int columns_ = 0, rows_ = 0;  ///< in tiles
  std::vector<std::weak_ptr<const DiffuseLattice>> tiles_;
};

}  // namespace boxprobe
