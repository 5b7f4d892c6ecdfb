// A probe's filtered chain as one flat texture (filters/math/cube/flat_cube.h), for programs of software renderers that
// have their numbers as constants: made when a draw first wants it. Called by the tuning for drivers, with the window's
// context current; knows no scene.
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

  /// Memory that all flat textures of a scene may take: those of some twenty probes with faces of 256 texels.
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  /// Is `radiance` of a shape that can be laid out flat?
  static bool fits(const CubeTexture& radiance);
  /// That it would take if it were made now: 0 if it is there.
  std::size_t bytesToMake(const CubeTexture& radiance) const;

  /// Reads the chain back, unless it is there; `total`, which counts the bytes of all, grows until it is released.
  /// False: there is no memory for it, which is not tried again before it is released.
  bool make(const CubeTexture& radiance, const std::shared_ptr<std::size_t>& total);
  /// The chain has changed, or is gone.
  void release();
  /// RGBA of 32 bits a channel, from faces of 512 texels on of 16; no mip levels. 0: not made.
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
