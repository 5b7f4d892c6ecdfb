// Lights that VTK has no code for, because a scene has many: a texture that the loop in shaders/gpu/light_list.glsl
// reads, with the lights and, for each object, those that reach it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class ListedLights {
 public:
  static constexpr int kTexels = 4;  ///< of a light

  ListedLights() = default;
  ~ListedLights() { release(); }
  ListedLights(const ListedLights&) = delete;
  ListedLights& operator=(const ListedLights&) = delete;

  /// Positions are kept relative to `center`, the middle of the scene.
  void set(const std::vector<Light>& lights, const glm::dvec3& center);
  bool empty() const { return lights_.empty(); }
  const glm::dvec3& center() const { return center_; }

  struct Reaching {
    int from = 0;  ///< the texel of the first index
    int count = 0;
  };
  /// The lights whose range meets these bounds, world space in VTK's order; null: all.
  Reaching reaching(const double* boundsWorld);
  /// RGBA32F, kWidth texels wide; the window's context is current.
  GLuint texture();
  void release();

 private:
  static constexpr std::size_t kWidth = 1024;  // light_list.glsl has it, too
  void startLists();

  struct Sphere {
    glm::dvec3 center{0.0};
    double radius = -1.0;  // negative: reaches everything
  };
  std::vector<Sphere> lights_;
  glm::dvec3 center_{0.0};
  std::vector<glm::vec4> texels_;  // lights, then indices, four a texel
  std::map<std::array<double, 6>, Reaching> lists_;
  std::size_t uploaded_ = 0;  // of texels_, in the texture
  std::size_t rows_ = 0;      // of the texture
  GLuint handle_ = 0;
};

}  // namespace boxprobe
