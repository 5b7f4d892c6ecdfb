// Runs one fragment shader from shaders/gpu over every pixel of the bound framebuffer, as one triangle without vertex
// data. Compiled at the first use.
#pragma once

#include <vtkShaderProgram.h>

#include <functional>
#include <string>
#include <vector>

#include "filters/core/base/counters.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Concatenates shader files in order, without duplicates.
std::string joinShaderSources(const std::vector<std::string>& files);

class FullScreenPass {
 public:
  /// `files` below shaders/, in order; the last one contains main(). `counters` (may be null) counts the compilation.
  FullScreenPass(const std::vector<std::string>& files, Counters* counters);
  /// A fragment shader as text; `name` is used in messages, `vertex` is the file of its vertex shader.
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
  vtkShaderProgram* program_ = nullptr;  // owned by the window's shader cache
  unsigned int vertexArray_ = 0;
};

}  // namespace boxprobe
