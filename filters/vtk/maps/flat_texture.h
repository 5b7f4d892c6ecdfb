// A probe's filtered chain as one flat texture (filters/math/cube/flat_cube.h), for specialized programs on software
// renderers: made when a draw first needs it. Needs the window's context current.
#pragma once

#include <cstddef>
#include <memory>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class CubeTexture;

class FlatTexture {
 public:
  FlatTexture() = default;
  ~FlatTexture() { release(); }
  FlatTexture(const FlatTexture&) = delete;
  FlatTexture& operator=(const FlatTexture&) = delete;

  /// Limit for all flat textures of a scene: those of about twenty probes with faces of 256 texels.
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  /// Can `radiance`, by its format and size, be laid out flat?
  static bool fits(const CubeTexture& radiance);
  /// Bytes needed to make it now: 0 if it exists.
  std::size_t bytesToMake(const CubeTexture& radiance) const;

  /// Reads the chain back, unless it exists; `total`, the bytes of all flat textures, is increased until release. False
  /// if memory is short; then not retried before release.
  bool make(const CubeTexture& radiance, const std::shared_ptr<std::size_t>& total);
  /// To be called when the chain has changed or is deleted.
  void release();
  /// RGBA32F, or RGBA16F for faces of at least 512 texels; no mip levels. 0: not made.
  GLuint handle() const { return handle_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void upload(const CubeTexture& radiance);

  GLuint handle_ = 0;
  bool refused_ = false;
  std::size_t bytes_ = 0;
  std::shared_ptr<std::size_t> total_;
};

}  // namespace boxprobe
