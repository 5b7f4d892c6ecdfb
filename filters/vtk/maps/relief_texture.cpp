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
    const CubeMap& texels = relief_->texels();
    texture_.allocate(texels.faceSize(), 1, GL_RGBA32F);
    const auto count = static_cast<std::size_t>(texels.faceSize()) * static_cast<std::size_t>(texels.faceSize()) * 4;
    for (int face = 0; face < 6; ++face) {
      texture_.writeFace(face, 0, std::vector<float>(texels.face(0, face), texels.face(0, face) + count));
    }
  }
  if (dragged) {
    if (auto latest = lazy_.latestBlocks()) return latest;
  }
  return lazy_.blocks(*relief_, probe.boxMin, probe.boxMax, glm::mat3(probe.mapFromProbe));
}

}  // namespace boxprobe
