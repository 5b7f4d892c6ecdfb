#include "filters/vtk/maps/openness_texture.h"

#include <array>

namespace boxprobe {

namespace {

void fill(GLuint& handle, const glm::ivec3& size, const std::uint8_t* texels) {
  GLint previous = 0, alignment = 4;
  glGetIntegerv(GL_TEXTURE_BINDING_3D, &previous);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  if (handle == 0) glGenTextures(1, &handle);
  glBindTexture(GL_TEXTURE_3D, handle);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, size.x, size.y, size.z, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_3D, name, GL_LINEAR);
  }
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
  }
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(previous));
}

}  // namespace

GLuint OpennessTexture::handle(const std::shared_ptr<const SkyOpenness>& open) {
  if (!open || open->empty()) {
    const std::array<std::uint8_t, 4> all = {128, 128, 128, 255};
    if (none_ == 0) fill(none_, glm::ivec3(1), all.data());
    return none_;
  }
  if (handle_ == 0 || of_ != open) {
    fill(handle_, open->nodes, open->texels.data());
    of_ = open;
  }
  return handle_;
}

void OpennessTexture::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  if (none_ != 0) glDeleteTextures(1, &none_);
  handle_ = none_ = 0;
  of_.reset();
}

}  // namespace boxprobe
