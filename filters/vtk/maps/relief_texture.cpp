#include "filters/vtk/maps/relief_texture.h"

#include <algorithm>

namespace boxprobe {

std::shared_ptr<const ReliefBlocks> ReliefTexture::blocks(const CubeTexture& distance, const ProbeGeometry& probe,
                                                          bool dragged) {
  if (!relief_) {
    CubeMap seen(distance.faceSize(), 1);
    for (int face = 0; face < 6; ++face) {
      const std::vector<float> rgba = distance.readFace(face, 0);
      std::copy(rgba.begin(), rgba.end(), seen.face(0, face));
    }
    relief_ = lazy_.of(seen);
    write(1);
  }
  if (dragged) {
    if (auto latest = lazy_.latestBlocks()) return latest;
  }
  return lazy_.blocks(*relief_, probe.boxMin, probe.boxMax, glm::mat3(probe.mapFromProbe));
}

bool ReliefTexture::makeLevels() {
  const int levels = 1 + (relief_->texels().faceSize() > 1 ? relief_->bounds().levels() : 0);
  if (texture_.levels() == levels) return false;
  write(levels);
  return true;
}

// The number of levels of a texture is fixed: it is recreated with more.
void ReliefTexture::write(int levels) {
  texture_.allocate(relief_->texels().faceSize(), levels, GL_RGBA32F);
  for (int level = 0; level < levels; ++level) {
    const CubeMap& map = level == 0 ? relief_->texels() : relief_->bounds();
    const int own = std::max(level - 1, 0);
    const auto size = static_cast<std::size_t>(map.levelSize(own));
    for (int face = 0; face < 6; ++face) {
      const float* texels = map.face(own, face);
      texture_.writeFace(face, level, std::vector<float>(texels, texels + size * size * 4));
    }
  }
}

}  // namespace boxprobe
