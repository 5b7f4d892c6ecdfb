// A probe's light table (filters/math/cube/light_table.h) as a texture, made from the capture when a draw first needs
// it. Needs the window's context current.
#pragma once

#include <cstddef>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class CubeTexture;

class LightTexture {
 public:
  LightTexture() = default;
  ~LightTexture() { release(); }
  LightTexture(const LightTexture&) = delete;
  LightTexture& operator=(const LightTexture&) = delete;

  /// Reads level 0 back once.
  void make(const CubeTexture& radiance);
  void release();
  /// RGBA32F, one row of cells per row; 0 if nothing is bright.
  GLuint handle() const { return handle_; }
  /// Cells along a face; 0: no table.
  int faceSize() const { return faceSize_; }
  std::size_t bytes() const;

 private:
  GLuint handle_ = 0;
  int faceSize_ = 0;
  bool made_ = false;
};

}  // namespace boxprobe
