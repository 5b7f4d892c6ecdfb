#include "filters/vtk/surface/uniform_upload.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

namespace boxprobe {

vtkOpenGLRenderWindow* UniformUpload::window() const {
  return vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
}

vtkCamera* UniformUpload::camera() const {
  return renderer->GetActiveCamera();
}

glm::dvec3 UniformUpload::eyeWorld() const {
  const double* eye = camera()->GetPosition();
  return {eye[0], eye[1], eye[2]};
}

bool UniformUpload::used(const std::string& name) const {
  return program->IsUniformUsed(name.c_str());
}

int UniformUpload::bind(GLenum target, GLuint handle) const {
  bound.push_back(std::make_unique<BoundTexture>(window(), target, handle));
  return bound.back()->unit();
}

void UniformUpload::texture(const std::string& name, GLenum target, GLuint handle) const {
  if (used(name)) program->SetUniformi(name.c_str(), bind(target, handle));  // units are scarce
}

}  // namespace boxprobe
