#include "filters/vtk/maps/coverage_texture.h"

#include <algorithm>

#include "filters/math/cube/openings.h"

namespace boxprobe {

void CoverageTexture::make(const CubeTexture& radiance, const CubeMap* tint, bool openIfWhole) {
  if (chain_) return;
  const int size = radiance.faceSize();
  CubeMap captured(size, 1);
  for (int face = 0; face < 6; ++face) {
    const std::vector<float> rgba = radiance.readFace(face, 0);
    std::copy(rgba.begin(), rgba.end(), captured.face(0, face));
  }
  const auto chain = std::make_shared<const CubeMap>(throughChain(captured, tint, openIfWhole));
  texture_.allocate(size, chain->levels(), GL_RGBA16F);
  for (int level = 0; level < chain->levels(); ++level) {
    const auto count =
        static_cast<std::size_t>(chain->levelSize(level)) * static_cast<std::size_t>(chain->levelSize(level));
    for (int face = 0; face < 6; ++face) {
      const float* texels = chain->face(level, face);
      texture_.writeFace(face, level, std::vector<float>(texels, texels + 4 * count));
    }
  }
  chain_ = chain;
}

}  // namespace boxprobe
