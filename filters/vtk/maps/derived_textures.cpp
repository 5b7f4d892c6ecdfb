#include "filters/vtk/maps/derived_textures.h"

#include <algorithm>

#include "filters/math/cube/light_table.h"
#include "filters/math/cube/openings.h"

namespace boxprobe {

namespace {

// Not readLevel0 of cube_transfer.h, which includes ProbeMaps and thereby these textures.
void readSharpest(const CubeTexture& texture, CubeMap& cube) {
  for (int face = 0; face < 6; ++face) texture.readFace(face, 0, cube.face(0, face));
}

}  // namespace

void CoverageTexture::make(const CubeTexture& radiance, const CubeMap* tint, bool openIfWhole) {
  if (chain_) return;
  const int size = radiance.faceSize();
  CubeMap captured(size, 1);
  readSharpest(radiance, captured);
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

void LightTexture::make(const CubeTexture& radiance) {
  if (made_ || !radiance.allocated()) return;
  made_ = true;
  CubeMap capture(radiance.faceSize(), 1);
  readSharpest(radiance, capture);
  const LightTable table = makeLightTable(capture);
  faceSize_ = table.faceSize;
  if (faceSize_ == 0) return;
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  glGenTextures(1, &handle_);
  glBindTexture(GL_TEXTURE_2D, handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, faceSize_, 6 * faceSize_, 0, GL_RGBA, GL_FLOAT, table.cells.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));
}

void LightTexture::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
  faceSize_ = 0;
  made_ = false;
}

std::size_t LightTexture::bytes() const {
  const auto size = static_cast<std::size_t>(faceSize_);
  return 6 * size * size * 16;
}

std::shared_ptr<const ReliefBlocks> ReliefTexture::blocks(const CubeTexture& distance, const ProbeGeometry& probe,
                                                          bool dragged) {
  if (!relief_) {
    CubeMap seen(distance.faceSize(), 1);
    readSharpest(distance, seen);
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
