// A probe's light table (filters/math/cube/light_table.h) as a texture, made from the capture when a draw first wants
// it. Called by the probe pass, with the window's context current; knows no scene.
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
  /// RGBA32F, a row of cells a row; 0 where nothing is bright.
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
