// One fragment shader from shaders/gpu run over every pixel of the bound framebuffer. Built on first use.
#pragma once

#include <vtkShaderProgram.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/counters.h"

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Shader files joined into one text: `files` in order, each once. What a fragment shader of ours is made of.
std::string joinShaderSources(const std::vector<std::string>& files);

class FullScreenPass {
 public:
  /// `files` below shaders/, in order; the last one holds main().
  FullScreenPass(std::vector<std::string> files, Counters* counters);
  ~FullScreenPass();
  FullScreenPass(const FullScreenPass&) = delete;
  FullScreenPass& operator=(const FullScreenPass&) = delete;

  /// Draws once; `setUniforms` is called with the program bound. Throws WorkError if the shader does not compile.
  void draw(vtkOpenGLRenderWindow* window, const std::function<void(vtkShaderProgram*)>& setUniforms);
  void release();

 private:
  std::vector<std::string> files_;
  Counters* counters_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

}  // namespace boxprobe
