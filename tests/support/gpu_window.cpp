#include "tests/support/gpu_window.h"

#include <vtkOpenGLState.h>
#include <vtkRenderWindow.h>
#include <vtkShaderProgram.h>

#include <memory>

#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe::test {

vtkSmartPointer<vtkOpenGLRenderWindow> makeWindow(int width, int height, int multiSamples) {
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(multiSamples);
  window->SetSize(width, height);
  auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  gl->Initialize();
  gl->MakeCurrent();
  return gl;
}

std::vector<std::vector<glm::vec4>> evaluateOnGpu(vtkOpenGLRenderWindow* window, const std::string& declarations,
                                                  const std::string& body,
                                                  const std::vector<std::vector<glm::vec4>>& inputs, int outputs) {
  constexpr int kWidth = 512;
  const std::size_t count = inputs.front().size();
  const int height = static_cast<int>((count + kWidth - 1) / kWidth);
  const std::size_t padded = static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(height);

  std::string source = declarations;
  for (std::size_t i = 0; i < inputs.size(); ++i) source += "\nuniform sampler2D tex" + std::to_string(i) + ";";
  source += "\nvoid main()\n{\n";
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    source +=
        "  vec4 in" + std::to_string(i) + " = texelFetch(tex" + std::to_string(i) + ", ivec2(gl_FragCoord.xy), 0);\n";
  }
  for (int i = 0; i < outputs; ++i) source += "  vec4 out" + std::to_string(i) + " = vec4(0.0);\n";
  source += body + "\n";
  for (int i = 0; i < outputs; ++i)
    source += "  gl_FragData[" + std::to_string(i) + "] = out" + std::to_string(i) + ";\n";
  source += "}\n";

  const auto makeTexture = [&](const glm::vec4* data) {
    GLuint handle = 0;
    glGenTextures(1, &handle);
    const BoundTexture bound(window, GL_TEXTURE_2D, handle);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, height, 0, GL_RGBA, GL_FLOAT, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return handle;
  };
  std::vector<GLuint> inputTextures, outputTextures;
  for (std::vector<glm::vec4> values : inputs) {
    values.resize(padded, values.front());
    inputTextures.push_back(makeTexture(values.data()));
  }
  for (int i = 0; i < outputs; ++i) outputTextures.push_back(makeTexture(nullptr));

  std::vector<std::vector<glm::vec4>> results;
  {
    const PassState saved(window);
    std::vector<FramebufferImage> images;
    for (const GLuint texture : outputTextures) images.push_back(textureImage(texture));
    Framebuffer framebuffer;
    framebuffer.attach(images, {}, floatRefusal("a test's outputs"));
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer.handle());
    window->GetState()->vtkglViewport(0, 0, kWidth, height);
    FullScreenPass pass("of a test", source);
    std::vector<std::unique_ptr<BoundTexture>> bound;
    pass.draw(window, [&](vtkShaderProgram* program) {
      for (std::size_t i = 0; i < inputTextures.size(); ++i) {
        bound.push_back(std::make_unique<BoundTexture>(window, GL_TEXTURE_2D, inputTextures[i]));
        program->SetUniformi(("tex" + std::to_string(i)).c_str(), bound.back()->unit());
      }
    });
    bound.clear();
    pass.release();
    for (int i = 0; i < outputs; ++i) {
      std::vector<glm::vec4> values(padded);
      glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
      glReadPixels(0, 0, kWidth, height, GL_RGBA, GL_FLOAT, values.data());
      values.resize(count);
      results.push_back(std::move(values));
    }
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  glDeleteTextures(static_cast<GLsizei>(inputTextures.size()), inputTextures.data());
  glDeleteTextures(static_cast<GLsizei>(outputTextures.size()), outputTextures.data());
  return results;
}

}  // namespace boxprobe::test
