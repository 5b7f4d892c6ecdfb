#include "filters/vtk/gl/mip_levels.h"

#include <algorithm>
#include <array>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

GLuint compiled(GLenum kind, const char* file) {
  const std::string text = "#version 150\n" + std::string(shaderSource(file));
  const char* source = text.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

/// The state that drawing the levels changes, saved and restored: called between draws of others, who track it.
class SavedState {
 public:
  SavedState() {
    for (std::size_t i = 0; i < kSwitches.size(); ++i) on_[i] = glIsEnabled(kSwitches[i]);
    glGetIntegerv(GL_VIEWPORT, viewport_);
    glGetBooleanv(GL_COLOR_WRITEMASK, mask_);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    for (const GLenum name : kSwitches) glDisable(name);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  ~SavedState() {
    for (std::size_t i = 0; i < kSwitches.size(); ++i)
      on_[i] == GL_TRUE ? glEnable(kSwitches[i]) : glDisable(kSwitches[i]);
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
    glUseProgram(static_cast<GLuint>(program_));
    glBindVertexArray(static_cast<GLuint>(vertexArray_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

 private:
  static constexpr std::array<GLenum, 8> kSwitches = {
      GL_BLEND,        GL_DEPTH_TEST,       GL_SCISSOR_TEST, GL_CULL_FACE,
      GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB, GL_MULTISAMPLE,  GL_SAMPLE_ALPHA_TO_COVERAGE};
  std::array<GLboolean, 8> on_{};
  GLint viewport_[4] = {}, program_ = 0, vertexArray_ = 0, draw_ = 0, read_ = 0;
  GLboolean mask_[4] = {};
};

}  // namespace

bool MipLevels::ready() {
  if (tried_) return program_ != 0;
  tried_ = true;
  const GLuint vertex = compiled(GL_VERTEX_SHADER, "gpu/mip_vertex.glsl");
  const GLuint fragment = compiled(GL_FRAGMENT_SHADER, "gpu/mip_level.glsl");
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint linked = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    glDeleteProgram(program_);
    program_ = 0;
    return false;
  }
  source_ = glGetUniformLocation(program_, "bpLevelAbove");
  glGenVertexArrays(1, &vertexArray_);
  return true;
}

void MipLevels::make(GLuint texture, GLenum internalFormat, int width, int height) {
  if (!tunedForCpu() || !drawsLevelFromLevel() || !ready()) {
    glGenerateMipmap(GL_TEXTURE_2D);
    return;
  }
  int levels = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++levels;
  for (int level = 1; level < levels; ++level) {
    glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(internalFormat), std::max(width >> level, 1),
                 std::max(height >> level, 1), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
  }
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
  }
  try {
    const SavedState saved;
    if (internalFormat == GL_SRGB8_ALPHA8) glEnable(GL_FRAMEBUFFER_SRGB);
    GLint unit = GL_TEXTURE0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    glUseProgram(program_);
    glUniform1i(source_, unit - GL_TEXTURE0);
    glBindVertexArray(vertexArray_);
    for (int level = 1; level < levels; ++level) {
      // A texture may be read and drawn to at the same time if the levels differ.
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level - 1);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
      framebuffer_.attach({textureImage(texture, GL_TEXTURE_2D, level)}, {}, floatRefusal("a mip level"));
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.handle());
      glViewport(0, 0, std::max(width >> level, 1), std::max(height >> level, 1));
      glDrawArrays(GL_TRIANGLE_FAN, 0, 4);
    }
  } catch (const WorkError&) {  // this driver cannot draw to such textures
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    glGenerateMipmap(GL_TEXTURE_2D);
    return;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

void MipLevels::release() {
  framebuffer_.release();
  if (program_ != 0) glDeleteProgram(program_);
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  program_ = vertexArray_ = 0;
  tried_ = false;
}

}  // namespace boxprobe
