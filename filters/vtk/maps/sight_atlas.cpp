#include "filters/vtk/maps/sight_atlas.h"

#include <algorithm>

namespace boxprobe {

namespace {

constexpr int kAcross = 4 * SightLattice::kMostNodes;

// The texture bound for the time of some calls.
class BoundSights {
 public:
  explicit BoundSights(GLuint handle) {
    glGetIntegerv(GL_TEXTURE_BINDING_3D, &previous_);
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment_);
    glBindTexture(GL_TEXTURE_3D, handle);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  ~BoundSights() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, alignment_);
    glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(previous_));
  }
  BoundSights(const BoundSights&) = delete;
  BoundSights& operator=(const BoundSights&) = delete;

 private:
  GLint previous_ = 0, alignment_ = 4;
};

}  // namespace

// The lowest floor and shelf that it fits into without wasting more than it takes.
std::optional<glm::ivec3> SightAtlas::room(const glm::ivec3& size) {
  for (Floor& floor : floors_) {
    if (size.z > floor.depth || 2 * size.z < floor.depth) continue;
    for (Shelf& shelf : floor.shelves) {
      if (size.y > shelf.height || 2 * size.y < shelf.height || shelf.x + size.x > kAcross) continue;
      const glm::ivec3 at(shelf.x, shelf.y, floor.z);
      shelf.x += size.x;
      return at;
    }
    if (floor.y + size.y > kAcross) continue;
    floor.shelves.push_back({floor.y, size.y, size.x});
    floor.y += size.y;
    return glm::ivec3(0, floor.shelves.back().y, floor.z);
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
  if (top_ + size.z > most) return std::nullopt;
  floors_.push_back({top_, size.z, size.y, {{0, size.y, size.x}}});
  top_ += size.z;
  return glm::ivec3(0, 0, floors_.back().z);
}

void SightAtlas::allocate() {
  if (handle_ == 0) glGenTextures(1, &handle_);
  const BoundSights bound(handle_);
  const int across = floors_.empty() ? 1 : kAcross;
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, across, across, depth_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_3D, name, GL_LINEAR);
  }
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
  }
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
}

void SightAtlas::upload(const Block& block) const {
  const auto sight = block.sight.lock();
  if (!sight) return;
  const BoundSights bound(handle_);
  glTexSubImage3D(GL_TEXTURE_3D, 0, block.at.x, block.at.y, block.at.z, block.size.x, block.size.y, block.size.z,
                  GL_RGBA, GL_UNSIGNED_BYTE, sight->lattice.texels.data());
}

// Those that are left, the deepest first, in a texture that has room for them. False: it would be too large.
bool SightAtlas::repack() {
  blocks_.erase(std::remove_if(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.sight.expired(); }),
                blocks_.end());
  std::stable_sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) {
    return a.size.z != b.size.z ? a.size.z > b.size.z : a.size.y > b.size.y;
  });
  floors_.clear();
  top_ = 0;
  bool all = true;
  for (auto block = blocks_.begin(); block != blocks_.end();) {
    if (const auto at = room(block->size)) {
      block->at = *at;
      ++block;
    } else {
      block = blocks_.erase(block);
      all = false;
    }
  }
  while (depth_ < top_) depth_ *= 2;
  allocate();
  for (const Block& block : blocks_) upload(block);
  return all;
}

std::optional<glm::vec3> SightAtlas::place(const std::shared_ptr<const ProbeSight>& sight) {
  if (!sight || sight->lattice.empty()) return std::nullopt;
  const auto found = [&] {
    return std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.sight.lock() == sight; });
  };
  if (const auto block = found(); block != blocks_.end()) return glm::vec3(block->at);
  const SightLattice& lattice = sight->lattice;
  Block block{sight, glm::ivec3(0), {lattice.nodes.x, lattice.nodes.y, lattice.nodes.z * lattice.parts()}};
  if (const auto at = room(block.size); at && handle_ != 0 && top_ <= depth_) {
    block.at = *at;
    blocks_.push_back(block);
    upload(block);
    return glm::vec3(block.at);
  }
  blocks_.push_back(block);
  repack();
  const auto placed = found();
  return placed != blocks_.end() ? std::optional<glm::vec3>(placed->at) : std::nullopt;
}

GLuint SightAtlas::handle() {
  if (handle_ == 0) allocate();
  return handle_;
}

glm::vec3 SightAtlas::texelSize() const {
  const int across = floors_.empty() ? 1 : kAcross;
  return 1.0f / glm::vec3(glm::ivec3(across, across, depth_));
}

void SightAtlas::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
  depth_ = 1;
  top_ = 0;
  floors_.clear();
  blocks_.clear();
}

}  // namespace boxprobe
