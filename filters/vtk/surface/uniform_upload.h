// One draw's program while its uniforms are uploaded: the camera it is seen through, and the textures that have to stay
// bound until it is drawn. Handed by the probe pass to the functions that upload one subject each (..._uniforms.h).
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/gl/gl_objects.h"

class vtkCamera;
class vtkRenderer;
class vtkShaderProgram;

namespace boxprobe {

struct UniformUpload {
  vtkShaderProgram* program;
  vtkRenderer* renderer;
  std::vector<std::unique_ptr<BoundTexture>>& bound;  ///< for the piece being drawn
  const double* boundsWorld = nullptr;                ///< of what is drawn, as VTK orders them; null: not known

  vtkOpenGLRenderWindow* window() const;
  vtkCamera* camera() const;
  glm::dvec3 eyeWorld() const;
  bool used(const std::string& name) const;

  /// Binds the texture to a unit of its own and returns that.
  int bind(GLenum target, GLuint handle) const;
  /// Binds it to a unit and tells the sampler `name` which.
  void texture(const std::string& name, GLenum target, GLuint handle) const;
  void texture2d(const std::string& name, GLuint handle) const { texture(name, GL_TEXTURE_2D, handle); }
  void cube(const std::string& name, GLuint handle) const { texture(name, GL_TEXTURE_CUBE_MAP, handle); }
};

}  // namespace boxprobe
