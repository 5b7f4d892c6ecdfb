#include "filters/vtk/maps/flat_texture.h"

#include <new>

#include "filters/math/cube/flat_cube.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

namespace {

// llvmpipe fetches floats faster than half floats, which it converts one by one; beyond this size memory matters more.
constexpr int kMostWideFaceSize = 256;
constexpr int kMostFaceSize = 512;

std::size_t texelBytes(int faceSize) {
  return faceSize <= kMostWideFaceSize ? 16 : 8;
}

}  // namespace

bool FlatTexture::fits(const CubeTexture& radiance) {
  if (!radiance.allocated()) return false;
  const int size = radiance.faceSize();
  const bool halves = (size & (size - 1)) == 0 && size >> (radiance.levels() - 1) > 0;  // down to its last level
  return halves && size <= kMostFaceSize;
}

std::size_t FlatTexture::bytesToMake(const CubeTexture& radiance) const {
  if (handle_ != 0) return 0;
  const auto size = static_cast<std::size_t>(radiance.faceSize());
  const std::size_t rows = 2 * size + 2 * static_cast<std::size_t>(radiance.levels());  // at most
  return 6 * (size + 2) * rows * texelBytes(radiance.faceSize());
}

bool FlatTexture::make(const CubeTexture& radiance, const std::shared_ptr<std::size_t>& total) {
  if (handle_ != 0) return true;
  if (refused_) return false;
  try {
    upload(radiance);
  } catch (const std::bad_alloc&) {  // must not propagate through a draw
    refused_ = true;
  }
  if (refused_) return false;
  total_ = total;
  *total_ += bytes_;
  return true;
}

void FlatTexture::upload(const CubeTexture& radiance) {
  CubeMap cube(radiance.faceSize(), radiance.levels());
  for (int level = 0; level < cube.levels(); ++level) {
    for (int face = 0; face < 6; ++face) radiance.readFace(face, level, cube.face(level, face));
  }
  const FlatCube flat = flattenCube(cube);
  const std::size_t each = texelBytes(radiance.faceSize());
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  while (glGetError() != GL_NO_ERROR) {  // discards earlier errors, which are not from this allocation
  }
  glGenTextures(1, &handle_);
  glBindTexture(GL_TEXTURE_2D, handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, each == 16 ? GL_RGBA32F : GL_RGBA16F, flat.width, flat.height, 0, GL_RGBA, GL_FLOAT,
               flat.rgba.data());
  refused_ = glGetError() != GL_NO_ERROR;
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));
  bytes_ = flat.rgba.size() / 4 * each;
  if (!refused_) return;
  glDeleteTextures(1, &handle_);
  handle_ = 0;
  bytes_ = 0;
}

void FlatTexture::release() {
  refused_ = false;
  if (handle_ == 0) return;
  glDeleteTextures(1, &handle_);
  *total_ -= bytes_;
  total_.reset();
  handle_ = 0;
  bytes_ = 0;
}

}  // namespace boxprobe
