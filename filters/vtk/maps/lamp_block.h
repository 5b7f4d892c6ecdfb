// Numbers of the lamps that a draw shows as shapes, as a block of uniforms: 16 lamps of 8 corners would take most of
// the 1,024 components that OpenGL promises a program outside of blocks.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "filters/vtk/gl/opengl.h"

class vtkShaderProgram;

namespace boxprobe {

/// As std140 has bpLampBlock of gpu/lamps.glsl.
template <int Lamps, int Corners>
struct LampNumbers {
  std::array<glm::vec4, Lamps * Corners> corner{};  ///< relative to the eye, world axes
  std::array<glm::vec4, Lamps> middle{};            ///< w: corners, and 16 more if both sides shine
  std::array<glm::vec4, Lamps> plane{};
  std::array<glm::vec4, Lamps> light{};    ///< radiance
  std::array<glm::vec4, Lamps> glossy{};   ///< radiance, less what the maps without lamps have in its place
  std::array<glm::vec4, Lamps> of{};       ///< 1 for each of the draw's probes whose lamp it is
  std::array<glm::vec4, Lamps> channel{};  ///< in each of them, where its visibility stands
};

class LampBlock {
 public:
  LampBlock() = default;
  ~LampBlock() { release(); }
  LampBlock(const LampBlock&) = delete;
  LampBlock& operator=(const LampBlock&) = delete;

  /// For what is drawn next with this program, with the window's context current.
  template <typename Numbers>
  void upload(vtkShaderProgram* program, const Numbers& numbers) {
    upload(program, &numbers, sizeof numbers);
  }
  void release();

 private:
  void upload(vtkShaderProgram* program, const void* bytes, std::size_t size);

  GLuint handle_ = 0;
};

}  // namespace boxprobe
