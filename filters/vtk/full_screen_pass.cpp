#include "filters/vtk/full_screen_pass.h"

#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>

#include "filters/core/errors.h"
#include "filters/math/shader_source.h"

namespace boxprobe {

std::string joinShaderSources(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) {
    text += shaderSource(file);
    text += '\n';
  }
  return text;
}

FullScreenPass::FullScreenPass(std::vector<std::string> files, Counters* counters)
    : files_(std::move(files)), counters_(counters) {}

FullScreenPass::~FullScreenPass() = default;

void FullScreenPass::draw(vtkOpenGLRenderWindow* window, const std::function<void(vtkShaderProgram*)>& setUniforms) {
  if (!quad_) {
    // VTK's own placeholders: the version line and the mapping of gl_FragData.
    const std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\n" + joinShaderSources(files_);
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), nullptr);
    if (counters_ != nullptr) ++counters_->programsCompiled;
  } else if (quad_->Program != nullptr) {
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  }
  if (quad_->Program == nullptr || !quad_->Program->GetCompiled()) {
    throw WorkError("the shader " + files_.back() + " does not compile on this driver");
  }
  setUniforms(quad_->Program);
  quad_->Render();
}

void FullScreenPass::release() { quad_.reset(); }

}  // namespace boxprobe
