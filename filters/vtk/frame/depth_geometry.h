// Positions of meshes' triangles on the GPU, each uploaded once, for depth-only passes. Every function needs the
// window's context current.
#pragma once

#include <map>
#include <memory>

#include "filters/core/scene/model.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class DepthGeometry {
 public:
  DepthGeometry() = default;
  ~DepthGeometry() { release(); }
  DepthGeometry(const DepthGeometry&) = delete;
  DepthGeometry& operator=(const DepthGeometry&) = delete;

  /// Draws with the current program, whose attribute bpPosition must be bound to location 0. `model` owns the mesh.
  void draw(const std::shared_ptr<const Model>& model, std::size_t mesh);
  void release();

 private:
  struct Buffers {
    std::weak_ptr<const Model> of;
    GLuint vertexArray = 0, positions = 0, indices = 0;
    GLsizei count = 0;
  };
  static void remove(Buffers& buffers);

  std::map<std::pair<const Model*, std::size_t>, Buffers> buffers_;
};

}  // namespace boxprobe
