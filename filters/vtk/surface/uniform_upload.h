// The program of a draw during the upload of its uniforms: the camera, and the textures that must stay bound until it
// is drawn. Passed to the upload functions (..._uniforms.h).
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
  const double* boundsWorld = nullptr;                ///< of what is drawn, in VTK's order; null: unknown

  vtkOpenGLRenderWindow* window() const;
  vtkCamera* camera() const;
  glm::dvec3 eyeWorld() const;
  bool used(const std::string& name) const;

  /// Binds the texture to a free unit, and returns that unit.
  int bind(GLenum target, GLuint handle) const;
  /// Binds the texture to a free unit, and sets the sampler `name` to it; nothing where the program has no such
  /// sampler.
  void texture(const std::string& name, GLenum target, GLuint handle) const;
  void texture2d(const std::string& name, GLuint handle) const { texture(name, GL_TEXTURE_2D, handle); }
  void cube(const std::string& name, GLuint handle) const { texture(name, GL_TEXTURE_CUBE_MAP, handle); }
};

}  // namespace boxprobe
