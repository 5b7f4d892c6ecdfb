// Numbers of the lamps that a draw shows as shapes, as a block of uniforms: 16 lamps of 8 corners would take most of
// the 1,024 components that OpenGL promises a program outside of blocks.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/gl/opengl.h"

class vtkShaderProgram;

namespace boxprobe {

/// As std140 has bpLampBlock of gpu/lamps.glsl.
struct LampNumbers {
  static constexpr std::size_t kLamps = ProbeBinding::kMaxLampsPerDraw, kCorners = 8;
  using OfEach = std::array<glm::vec4, kLamps>;

  std::array<glm::vec4, kLamps * kCorners> corner{};  ///< relative to the eye, world axes
  OfEach middle{};                                    ///< w: corners, and 16 more if both sides shine
  OfEach plane{};
  OfEach light{};    ///< radiance
  OfEach glossy{};   ///< radiance, less what the maps without lamps have in its place
  OfEach of{};       ///< 1 for each of the draw's probes whose lamp it is
  OfEach channel{};  ///< in each of them, where its visibility stands
};

class LampBlock {
 public:
  LampBlock() = default;
  ~LampBlock() { release(); }
  LampBlock(const LampBlock&) = delete;
  LampBlock& operator=(const LampBlock&) = delete;

  /// For what is drawn next with this program, with the window's context current.
  void upload(vtkShaderProgram* program, const LampNumbers& numbers);
  void release();

 private:
  GLuint handle_ = 0;
};

}  // namespace boxprobe
