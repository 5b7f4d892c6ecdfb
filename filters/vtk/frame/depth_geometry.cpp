#include "filters/vtk/frame/depth_geometry.h"

namespace boxprobe {

void DepthGeometry::remove(Buffers& buffers) {
  glDeleteVertexArrays(1, &buffers.vertexArray);
  glDeleteBuffers(1, &buffers.positions);
  glDeleteBuffers(1, &buffers.indices);
}

void DepthGeometry::draw(const std::shared_ptr<const Model>& model, std::size_t mesh) {
  for (auto it = buffers_.begin(); it != buffers_.end();) {
    const bool gone = it->second.of.expired();
    if (gone) remove(it->second);
    it = gone ? buffers_.erase(it) : std::next(it);
  }
  Buffers& b = buffers_[{model.get(), mesh}];
  if (b.vertexArray == 0) {
    const Mesh& m = model->meshes[mesh];
    b.of = model;
    b.count = static_cast<GLsizei>(m.indices.size());
    glGenVertexArrays(1, &b.vertexArray);
    glGenBuffers(1, &b.positions);
    glGenBuffers(1, &b.indices);
    glBindVertexArray(b.vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, b.positions);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m.positions.size() * sizeof m.positions[0]),
                 m.positions.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof m.positions[0], nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, b.indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(m.indices.size() * sizeof m.indices[0]),
                 m.indices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  glBindVertexArray(b.vertexArray);
  glDrawElements(GL_TRIANGLES, b.count, GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

void DepthGeometry::release() {
  for (auto& [key, buffers] : buffers_) remove(buffers);
  buffers_.clear();
}

}  // namespace boxprobe
