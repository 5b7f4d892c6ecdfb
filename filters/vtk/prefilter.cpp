#include "filters/vtk/prefilter.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cmath>

#include "filters/math/shared_math.h"

namespace boxprobe {

int prefilterLevels(int faceSize) {
  int levels = 1;
  for (int size = faceSize; size > 4; size /= 2) ++levels;
  return levels;
}

std::vector<glm::vec4> lobeSamples(float roughness, int count, int sourceFaceSize) {
  const double alpha = static_cast<double>(roughness) * roughness;
  // With N = V a half vector beyond 45 degrees reflects below the horizon: tan²(theta) = alpha² u / (1 - u) < 1.
  const double cut = 1.0 / (1.0 + alpha * alpha);
  const double texelSolidAngle = 4.0 * 3.14159265358979 / (6.0 * sourceFaceSize * sourceFaceSize);
  std::vector<glm::vec4> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double azimuth = std::fmod(i * 0.6180339887498949, 1.0);
    const double u = cut * (i + 0.5) / count;
    const glm::vec3 half = shading::ggxHalfVector(glm::vec2(azimuth, u), static_cast<float>(alpha));
    const glm::vec3 light = 2.0f * half.z * half - glm::vec3(0.0f, 0.0f, 1.0f);
    // Density of the reflected direction: D(h) (n.h) / (4 v.h) = D / 4 for v = n, over the part above the horizon.
    const double density = shading::ggxDistribution(half, static_cast<float>(alpha)) / 4.0 / cut;
    const double solidAngle = 1.0 / (count * density);
    const double level = 0.5 * std::log2(std::max(solidAngle / texelSolidAngle, 1.0));
    samples.emplace_back(light, static_cast<float>(level));
  }
  return samples;
}

Prefilter::Prefilter(vtkOpenGLRenderWindow* window, Counters* counters)
    : window_(window), counters_(counters), pass_({"shared/cube.glsl", "gpu/prefilter_ggx.glsl"}, counters) {}

void Prefilter::begin(const CubeTexture& source, const CubeTexture& chain) {
  const PassState saved(window_);
  {
    const BoundTexture bound(window_, GL_TEXTURE_CUBE_MAP, source.handle());
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
  }
  const int size = source.faceSize();
  for (int face = 0; face < 6; ++face) {
    to_.bind(window_, chain, face, 0);
    from_.bind(window_, source, face, 0);
    to_.bindDraw(window_);
    glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
}

void Prefilter::filterLevel(const CubeTexture& source, const CubeTexture& chain, int level) {
  const PassState saved(window_);
  const float roughness = shading::roughnessForLevel(static_cast<float>(level), static_cast<float>(chain.levels() - 1));
  const std::vector<glm::vec4> samples = lobeSamples(roughness, kSamples, source.faceSize());
  const BoundTexture bound(window_, GL_TEXTURE_CUBE_MAP, source.handle());
  for (int face = 0; face < 6; ++face) {
    to_.bind(window_, chain, face, level);
    pass_.draw(window_, [&](vtkShaderProgram* program) {
      program->SetUniformi("bpSource", bound.unit());
      program->SetUniformi("bpFace", face);
      program->SetUniformf("bpFaceSize", static_cast<float>(chain.faceSize() >> level));
      program->SetUniformi("bpSampleCount", kSamples);
      program->SetUniform4fv("bpSamples", kSamples, reinterpret_cast<const float(*)[4]>(&samples[0].x));
    });
  }
  ++counters_->levelsFiltered;
}

ShCoefficients Prefilter::irradiance(const CubeTexture& source) {
  int level = 0;
  while ((source.faceSize() >> level) > 16) ++level;
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) faces[static_cast<std::size_t>(face)] = source.readFace(face, level);
  return irradianceCoefficients(faces, source.faceSize() >> level);
}

void Prefilter::release() {
  from_.release();
  to_.release();
  pass_.release();
}

}  // namespace boxprobe
