#include "filters/vtk/maps/light_texture.h"

#include <algorithm>

#include "filters/math/cube/light_table.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

void LightTexture::make(const CubeTexture& radiance) {
  if (made_ || !radiance.allocated()) return;
  made_ = true;
  CubeMap capture(radiance.faceSize(), 1);
  for (int face = 0; face < 6; ++face) {
    const std::vector<float> rgba = radiance.readFace(face, 0);
    std::copy(rgba.begin(), rgba.end(), capture.face(0, face));
  }
  const LightTable table = makeLightTable(capture);
  faceSize_ = table.faceSize;
  if (faceSize_ == 0) return;
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  glGenTextures(1, &handle_);
  glBindTexture(GL_TEXTURE_2D, handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, faceSize_, 6 * faceSize_, 0, GL_RGBA, GL_FLOAT, table.cells.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));
}

void LightTexture::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
  faceSize_ = 0;
  made_ = false;
}

std::size_t LightTexture::bytes() const {
  const auto size = static_cast<std::size_t>(faceSize_);
  return 6 * size * size * 16;
}

}  // namespace boxprobe
