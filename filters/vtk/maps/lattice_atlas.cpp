#include "filters/vtk/maps/lattice_atlas.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

constexpr int kSide = DiffuseLattice::kMostNodes;
constexpr int kDepth = (DiffuseLattice::kParts + DiffuseLattice::kCutParts) * DiffuseLattice::kMostNodes;

// Binds the texture during some calls.
class Bound {
 public:
  explicit Bound(GLuint handle) {
    glGetIntegerv(GL_TEXTURE_BINDING_3D, &previous_);
    glBindTexture(GL_TEXTURE_3D, handle);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  ~Bound() { glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(previous_)); }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

 private:
  GLint previous_ = 0;
};

}  // namespace

glm::ivec3 LatticeAtlas::first(std::size_t tile) const {
  const auto index = static_cast<int>(tile);
  return {index % columns_ * kSide, index / columns_ * kSide, 0};
}

void LatticeAtlas::upload(std::size_t tile) const {
  const auto lattice = tiles_[tile].lock();
  if (!lattice || lattice->empty()) return;
  const glm::ivec3 at = first(tile), nodes = lattice->nodes;
  const Bound bound(handle_);
  // Parts are contiguous in memory and in the texture: uploaded as one block of nodes.
  glTexSubImage3D(GL_TEXTURE_3D, 0, at.x, at.y, at.z, nodes.x, nodes.y, DiffuseLattice::kParts * nodes.z, GL_RGBA,
                  GL_FLOAT, lattice->texels.data());
  if (lattice->cuts.empty()) return;
  glTexSubImage3D(GL_TEXTURE_3D, 0, at.x, at.y, at.z + DiffuseLattice::kParts * nodes.z, nodes.x, nodes.y,
                  DiffuseLattice::kCutParts * nodes.z, GL_RGBA, GL_FLOAT, lattice->cuts.data());
}

// Texels beyond a lattice's last nodes would hold what was in memory. Filtering should give them no weight, but by
// Mesa's softpipe they show. By slices, since all of it may be hundreds of megabytes.
void LatticeAtlas::fillWithNothing() const {
  const std::vector<std::uint16_t> none(static_cast<std::size_t>(4 * kSide * columns_) *
                                        static_cast<std::size_t>(kSide * rows_));
  for (int z = 0; z < kDepth; ++z) {
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, columns_ * kSide, rows_ * kSide, 1, GL_RGBA, GL_HALF_FLOAT, none.data());
  }
}

// Doubles the tiles; all are uploaded again if the columns have moved.
void LatticeAtlas::grow() {
  if (columns_ == 0) {
    columns_ = rows_ = 1;
  } else if (columns_ <= rows_) {
    columns_ *= 2;
  } else {
    rows_ *= 2;
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
  if (columns_ * kSide > most || rows_ * kSide > most || kDepth > most) {
    throw WorkError("the diffuse light of so many probes does not fit into one texture");
  }
  if (handle_ == 0) glGenTextures(1, &handle_);
  {
    const Bound bound(handle_);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, columns_ * kSide, rows_ * kSide, kDepth, 0, GL_RGBA, GL_FLOAT, nullptr);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTexParameteri(GL_TEXTURE_3D, name, GL_LINEAR);
    }
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
      glTexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    fillWithNothing();
  }
  tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) upload(tile);
}

glm::vec3 LatticeAtlas::place(const std::shared_ptr<const DiffuseLattice>& lattice) {
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
    if (tiles_[tile].lock() == lattice) return first(tile);
  }
  std::size_t tile = 0;
  while (tile < tiles_.size() && !tiles_[tile].expired()) ++tile;
  if (tile == tiles_.size()) grow();
  tiles_[tile] = lattice;
  upload(tile);
  return first(tile);
}

glm::vec3 LatticeAtlas::texelSize() const {
  return 1.0f / glm::vec3(glm::ivec3(std::max(columns_, 1) * kSide, std::max(rows_, 1) * kSide, kDepth));
}

void LatticeAtlas::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
  columns_ = rows_ = 0;
  tiles_.clear();
}

}  // namespace boxprobe
