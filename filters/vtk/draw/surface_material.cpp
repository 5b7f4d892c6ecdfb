#include "filters/vtk/draw/surface_material.h"

#include <utility>

#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

GLint wrapMode(Wrap wrap) {
  if (wrap == Wrap::ClampToEdge) return GL_CLAMP_TO_EDGE;
  return wrap == Wrap::MirroredRepeat ? GL_MIRRORED_REPEAT : GL_REPEAT;
}

}  // namespace

const std::array<const char*, kSurfaceSlots>& surfaceSlotNames() {
  static const std::array<const char*, kSurfaceSlots> names = {
      "BaseColor",     "RoughMetal",     "Normal",       "Occlusion",   "Emissive",     "Coat",
      "CoatRoughness", "CoatNormal",     "Transmission", "Thickness",   "Specular",     "SpecularColor",
      "SheenColor",    "SheenRoughness", "Anisotropy",   "Iridescence", "FilmThickness"};
  return names;
}

SurfaceTexture::SurfaceTexture(const TextureUse& use, bool srgb, std::shared_ptr<MipLevels> mips)
    : image_(use.image),
      mips_(std::move(mips)),
      wrapS_(use.wrapS),
      wrapT_(use.wrapT),
      srgb_(srgb),
      nearest_(use.nearest) {}

GLuint SurfaceTexture::handle() const {
  if (handle_ != 0) return handle_;
  GLint previousTexture = 0, previousAlignment = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previousTexture);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &previousAlignment);
  glGenTextures(1, &handle_);
  glBindTexture(GL_TEXTURE_2D, handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  // Rows in file order, from the top: v = 0 is the first row, as in glTF.
  const GLenum format = srgb_ ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), image_->width, image_->height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, image_->pixels.data());
  mips_->make(handle_, format, image_->width, image_->height);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, nearest_ ? 1.0f : textureAnisotropy());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nearest_ ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest_ ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapMode(wrapS_));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapMode(wrapT_));
  glPixelStorei(GL_UNPACK_ALIGNMENT, previousAlignment);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previousTexture));
  return handle_;
}

void SurfaceTexture::release() const {
  if (handle_ == 0) return;
  glDeleteTextures(1, &handle_);
  handle_ = 0;
  mips_->release();
}

std::string SurfaceMaterial::programKey() const {
  std::string key;
  for (const SurfaceSlot& slot : slots) key += slot.texture ? static_cast<char>('0' + slot.uvSet) : '-';
  for (const bool set : {uv[0], uv[1], colors, tangents, unlit, finish.tintsSpecular(), finish.hasSheen(),
                         finish.hasFilm(), finish.isAnisotropic()})
    key += set ? '1' : '0';
  return key + static_cast<char>('0' + static_cast<int>(alphaMode)) + std::to_string(glass.drawn ? glass.variant() : 0);
}

std::size_t SurfaceTexture::bytes() const {
  // A mip chain adds a third to its largest level.
  return handle_ == 0 ? 0 : image_->pixels.size() * 4 / 3;
}

}  // namespace boxprobe
