// Triangles of meshes on the graphics side, positions alone, each uploaded once: for passes that draw depth and nothing
// else. Every function needs the window's context current. Knows no scene.
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

  /// With the current program, whose attribute bpPosition is bound to location 0. `model` owns the mesh.
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
