// One fragment shader from shaders/gpu run over every pixel of the bound framebuffer, as one triangle without vertex
// data. Built on first use.
#pragma once

#include <vtkShaderProgram.h>

#include <functional>
#include <string>
#include <vector>

#include "filters/core/base/counters.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Shader files joined into one text: `files` in order, each once. What a fragment shader of ours is made of.
std::string joinShaderSources(const std::vector<std::string>& files);

class FullScreenPass {
 public:
  /// `files` below shaders/, in order; the last one holds main(). `counters` (may be null) learns of the compilation.
  FullScreenPass(const std::vector<std::string>& files, Counters* counters);
  /// A fragment shader as text; `name` stands for it in messages, `vertex` is the file of its vertex shader.
  FullScreenPass(std::string name, std::string source, Counters* counters = nullptr,
                 std::string vertex = "gpu/full_screen_vertex.glsl");
  ~FullScreenPass();
  FullScreenPass(const FullScreenPass&) = delete;
  FullScreenPass& operator=(const FullScreenPass&) = delete;

  /// Draws once; `setUniforms` is called with the program bound. Throws WorkError if the shader does not compile.
  void draw(vtkOpenGLRenderWindow* window, const std::function<void(vtkShaderProgram*)>& setUniforms);
  void release();

 private:
  std::string name_;
  std::string source_, vertex_;
  Counters* counters_ = nullptr;
  vtkShaderProgram* program_ = nullptr;  // the window's shader cache owns it
  unsigned int vertexArray_ = 0;
};

}  // namespace boxprobe
