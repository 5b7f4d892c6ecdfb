#include "filters/vtk/capture/prefilter.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>

#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

Prefilter::Prefilter(vtkOpenGLRenderWindow* window, Counters* counters)
    : window_(window),
      counters_(counters),
      sourcePass_(
          {"shared/cube.glsl", "shared/source_level.glsl", "gpu/nearest_half.glsl", "gpu/prefilter_source.glsl"},
          counters),
      lobePass_({"shared/cube.glsl", "shared/lobe_frame.glsl", "gpu/nearest_half.glsl", "gpu/prefilter_lobe.glsl"},
                counters),
      flatPass_("gpu/prefilter_lobe.glsl from a flat picture",
                "#define BP_FLAT_SOURCE\n" +
                    joinShaderSources({"shared/cube.glsl", "shared/lobe_frame.glsl", "gpu/nearest_half.glsl",
                                       "gpu/flat_lookup.glsl", "gpu/prefilter_lobe.glsl"}),
                counters),
      fixupPass_("gpu/prefilter_lobe.glsl with edge fix-up",
                 "#define BP_EDGE_FIXUP\n" +
                     joinShaderSources({"shared/cube.glsl", "shared/lobe_frame.glsl", "shared/edge_fixup.glsl",
                                        "gpu/nearest_half.glsl", "gpu/prefilter_lobe.glsl"}),
                 counters) {}

void Prefilter::makeSourceLevels(const CubeTexture& source) {
  const PassState saved(window_);
  const BoundTexture bound(window_, GL_TEXTURE_CUBE_MAP, source.handle());
  for (int level = 1; level < source.levels(); ++level) {
    // A texture may be read and drawn to at the same time if the levels differ.
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BASE_LEVEL, level - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, level - 1);
    for (int face = 0; face < 6; ++face) {
      to_.bind(window_, source, face, level);
      sourcePass_.draw(window_, [&](vtkShaderProgram* program) {
        program->SetUniformi("bpSource", bound.unit());
        program->SetUniformi("bpFace", face);
        program->SetUniformf("bpFaceSize", static_cast<float>(source.faceSize() >> level));
        program->SetUniformf("bpLevel", 0.0f);
      });
    }
  }
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, source.levels() - 1);
  forgetSource();
}

// Making the flat picture takes as long as it saves for about eight lookups per source texel, which only fine levels
// have. The choice depends on the level alone, so that its texels are always bit-identical.
bool Prefilter::flattened(const CubeTexture& source, std::size_t lookups) {
  const auto size = static_cast<std::size_t>(source.faceSize());
  if (!tunedForCpu() || !FlatTexture::fits(source) || lookups < 8 * 6 * size * size) return false;
  if (flatOf_ == source.handle()) return true;
  flat_.release();
  if (!flat_.make(source, flatBytes_)) return false;
  ++counters_->sourcesFlattened;
  flatOf_ = source.handle();
  return true;
}

void Prefilter::forgetSource() {
  flat_.release();
  flatOf_ = 0;
}

void Prefilter::begin(const CubeTexture& source, const CubeTexture& chain, const PrefilterSettings& settings) {
  makeSourceLevels(source);
  if (lobeOfLevel(settings, 0, chain.levels() - 1).width > 0.0f) {
    filterLevel(source, chain, 0, settings);
    return;
  }
  copyLevel(source, chain, 0);
}

void Prefilter::copyLevel(const CubeTexture& from, const CubeTexture& to, int level) {
  const PassState saved(window_);
  const int size = to.faceSize() >> level;
  for (int face = 0; face < 6; ++face) {
    to_.bind(window_, to, face, level);
    from_.bind(window_, from, face, level);
    to_.bindDraw(window_);
    glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
}

const std::vector<LobeTap>& Prefilter::tapsOf(const FilterLobe& lobe, int samples, int faceSize) {
  constexpr std::size_t kKept = 16;
  for (const Taps& known : taps_) {
    if (known.lobe.kind == lobe.kind && known.lobe.width == lobe.width && known.samples == samples &&
        known.faceSize == faceSize) {
      return known.taps;
    }
  }
  if (taps_.size() == kKept) taps_.erase(taps_.begin());
  taps_.push_back({lobe, samples, faceSize, lobeTaps(lobe, samples, faceSize)});
  return taps_.back().taps;
}

void Prefilter::filterLevel(const CubeTexture& source, const CubeTexture& chain, int level,
                            const PrefilterSettings& settings) {
  const FilterLobe lobe = lobeOfLevel(settings, level, chain.levels() - 1);
  filterWith(source, chain, level, tapsOf(lobe, samplesOfLevel(settings, level), source.faceSize()),
             settings.filter == FilterLobe::Kind::Gaussian ? settings.gaussian.edgeFixupWidth : 0);
}

void Prefilter::filterWith(const CubeTexture& source, const CubeTexture& chain, int level,
                           const std::vector<LobeTap>& taps, int edgeFixupWidth) {
  const PassState saved(window_);
  const int size = chain.faceSize() >> level;
  const int count = std::min(static_cast<int>(taps.size()), kMaxSamples);
  std::vector<std::array<float, 4>> packed;
  for (const LobeTap& tap : taps) packed.push_back({tap.direction.x, tap.direction.y, tap.level, tap.weight});
  const std::size_t lookups = 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * taps.size();
  const bool fixup = edgeFixupWidth > 0, flat = !fixup && flattened(source, lookups);
  const BoundTexture bound(window_, flat ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP,
                           flat ? flat_.handle() : source.handle());
  FullScreenPass& pass = fixup ? fixupPass_ : flat ? flatPass_ : lobePass_;
  if (tapBuffer_ == 0) glGenBuffers(1, &tapBuffer_);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, tapBuffer_);
  glBufferData(GL_UNIFORM_BUFFER, kMaxSamples * static_cast<GLsizeiptr>(sizeof packed[0]), nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, count * static_cast<GLsizeiptr>(sizeof packed[0]), packed.data());
  for (int face = 0; face < 6; ++face) {
    to_.bind(window_, chain, face, level);
    pass.draw(window_, [&](vtkShaderProgram* program) {
      program->SetUniformi("bpSource", bound.unit());
      program->SetUniformi("bpFace", face);
      program->SetUniformf("bpFaceSize", static_cast<float>(size));
      if (flat) {
        program->SetUniformf("bpSourceSize", static_cast<float>(source.faceSize()));
        program->SetUniformf("bpSourceMaxLevel", static_cast<float>(source.levels() - 1));
      }
      if (fixup) {
        program->SetUniformf("bpFixupWidth", static_cast<float>(std::min(edgeFixupWidth, size / 2)));
      }
      program->SetUniformi("bpTapCount", count);
      const auto number = static_cast<GLuint>(program->GetHandle());
      glUniformBlockBinding(number, glGetUniformBlockIndex(number, "bpTapBlock"), 0);
    });
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);
  ++counters_->levelsFiltered;
}

ShCoefficients Prefilter::irradiance(const CubeTexture& source, const glm::dmat3& worldFromMap) {
  int level = 0;
  while ((source.faceSize() >> level) > 16) ++level;
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) faces[static_cast<std::size_t>(face)] = source.readFace(face, level);
  return irradianceCoefficients(faces, source.faceSize() >> level, worldFromMap);
}

void Prefilter::release() {
  from_.release();
  to_.release();
  sourcePass_.release();
  lobePass_.release();
  flatPass_.release();
  forgetSource();
  fixupPass_.release();
  if (tapBuffer_ != 0) glDeleteBuffers(1, &tapBuffer_);
  tapBuffer_ = 0;
}

}  // namespace boxprobe
