#include "filters/vtk/gl/full_screen_pass.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

std::string joinShaderSources(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) {
    text += shaderSource(file);
    text += '\n';
  }
  return text;
}

FullScreenPass::FullScreenPass(const std::vector<std::string>& files, Counters* counters)
    : FullScreenPass(files.back(), joinShaderSources(files), counters) {}

FullScreenPass::FullScreenPass(std::string name, std::string source, Counters* counters, std::string vertex)
    : name_(std::move(name)), source_(std::move(source)), vertex_(std::move(vertex)), counters_(counters) {}

FullScreenPass::~FullScreenPass() = default;

void FullScreenPass::draw(vtkOpenGLRenderWindow* window, const std::function<void(vtkShaderProgram*)>& setUniforms) {
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (program_ == nullptr) {
    // VTK's own placeholders: the version line and the mapping of gl_FragData.
    std::string fragment = "//VTK::System::Dec\n//VTK::Output::Dec\n" + source_;
    breakShaderIfAsked(fragment, name_);
    const std::string vertex = "//VTK::System::Dec\n" + std::string(shaderSource(vertex_));
    program_ = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
    if (counters_ != nullptr) ++counters_->programsCompiled;
    glGenVertexArrays(1, &vertexArray_);
  } else {
    cache->ReadyShaderProgram(program_);
  }
  if (program_ == nullptr || !program_->GetCompiled()) {
    throw WorkError("the shader " + name_ + " does not compile on this driver");
  }
  setUniforms(program_);
  glBindVertexArray(vertexArray_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void FullScreenPass::release() {
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
  program_ = nullptr;
}

}  // namespace boxprobe
