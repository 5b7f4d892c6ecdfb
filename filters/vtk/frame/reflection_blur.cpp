#include "filters/vtk/frame/reflection_blur.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <cmath>
#include <optional>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

namespace {

std::string blurSource(bool last) {
  return std::string("#define BP_LAST ") + (last ? "1\n" : "0\n") +
         std::string(shaderSource("gpu/reflection_blur.glsl"));
}

}  // namespace

ReflectionBlur::ReflectionBlur(Counters* counters)
    : first_("gpu/reflection_blur.glsl", blurSource(false), counters),
      last_("gpu/reflection_blur.glsl", blurSource(true), counters) {}

void ReflectionBlur::draw(vtkOpenGLRenderWindow* window, vtkCamera* camera, const FrameTarget& sums, int frames,
                          const FrameTarget& surfaces, int rays) {
  const int width = sums.width(), height = sums.height();
  half_.allocate(width, height, 0, 1);
  smoothed_.allocate(width, height, 0, 1);
  const bool parallel = camera->GetParallelProjection() != 0;
  const double up =
      parallel ? camera->GetParallelScale() : std::tan(0.5 * camera->GetViewAngle() * std::acos(-1.0) / 180.0);
  const double aspect =
      camera->GetUseExplicitAspectRatio() != 0 ? camera->GetExplicitAspectRatio() : static_cast<double>(width) / height;
  const float tangents[2] = {static_cast<float>(up * aspect), static_cast<float>(up)};
  const float size[2] = {static_cast<float>(width), static_cast<float>(height)};
  const float scale = 1.0f / static_cast<float>(frames);

  vtkOpenGLState* state = window->GetState();
  const PassState saved(window);
  state->vtkglViewport(0, 0, width, height);
  const BoundTexture surface(window, GL_TEXTURE_2D, surfaces.texture(3));
  const BoundTexture reflection(window, GL_TEXTURE_2D, sums.texture(1));
  for (const bool last : {false, true}) {
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, (last ? smoothed_ : half_).framebuffer());
    std::optional<BoundTexture> half, color, share;
    if (last) {
      half.emplace(window, GL_TEXTURE_2D, half_.texture(0));
      color.emplace(window, GL_TEXTURE_2D, sums.texture(0));
      share.emplace(window, GL_TEXTURE_2D, surfaces.texture(2));
    }
    (last ? last_ : first_).draw(window, [&](vtkShaderProgram* program) {
      program->SetUniformi("bpSurface", surface.unit());
      program->SetUniformi("bpReflection", last ? half->unit() : reflection.unit());
      program->SetUniformf("bpScale", last ? 1.0f : scale);
      program->SetUniformi("bpStep", last ? 2 : 1);
      program->SetUniformf("bpRays", static_cast<float>(rays));
      program->SetUniform2f("bpTangents", tangents);
      program->SetUniform2f("bpSize", size);
      program->SetUniformf("bpParallelView", parallel ? 1.0f : 0.0f);
      if (!last) return;
      program->SetUniformi("bpColor", color->unit());
      program->SetUniformi("bpFirst", reflection.unit());
      program->SetUniformi("bpShare", share->unit());
      program->SetUniformf("bpColorScale", scale);
    });
  }
}

void ReflectionBlur::releaseTargets() {
  half_.release();
  smoothed_.release();
}

void ReflectionBlur::release() {
  releaseTargets();
  first_.release();
  last_.release();
}

}  // namespace boxprobe
