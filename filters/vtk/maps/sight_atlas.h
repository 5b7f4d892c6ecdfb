// The lattices of visibilities of all probes in one three-dimensional texture (filters/core/geometry/lamp_sight.h):
// one sampler, however many probes a draw has. Filled by the probe pass's uniforms, with the window's context current.
#pragma once

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class SightAtlas {
 public:
  SightAtlas() = default;
  ~SightAtlas() { release(); }
  SightAtlas(const SightAtlas&) = delete;
  SightAtlas& operator=(const SightAtlas&) = delete;

  /// Texel where the sight's lattice begins, which is uploaded if it is not there. Nothing: it is empty, or the
  /// driver's largest texture is full. Lattices that exist no more are left out when the texture grows.
  std::optional<glm::vec3> place(const std::shared_ptr<const ProbeSight>& sight);
  /// RGBA, a byte each, linear; never 0.
  GLuint handle();
  /// 1 / its texels along each axis.
  glm::vec3 texelSize() const;
  void release();

 private:
  struct Block {
    std::weak_ptr<const ProbeSight> sight;
    glm::ivec3 at{0}, size{0};
  };
  // Blocks stand on floors, side by side in shelves.
  struct Shelf {
    int y = 0, height = 0, x = 0;
  };
  struct Floor {
    int z = 0, depth = 0, y = 0;
    std::vector<Shelf> shelves;
  };

  std::optional<glm::ivec3> room(const glm::ivec3& size);
  bool repack();
  void allocate();
  void upload(const Block& block) const;

  GLuint handle_ = 0;
  int depth_ = 1, top_ = 0;  ///< texels, and those that floors have taken
  std::vector<Floor> floors_;
  std::vector<Block> blocks_;
};

}  // namespace boxprobe
