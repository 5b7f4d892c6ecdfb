#include "filters/vtk/gl/program_check.h"

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "filters/core/base/scope_exit.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

namespace {

bool isSampler(GLenum type) {
  return type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_CUBE || type == GL_SAMPLER_2D_SHADOW ||
         type == GL_SAMPLER_1D || type == GL_SAMPLER_BUFFER || type == GL_INT_SAMPLER_BUFFER;
}

// Those that are left once the driver has removed what nothing reads.
int samplers(GLuint program) {
  GLint uniforms = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  int count = 0;
  for (GLint i = 0; i < uniforms; ++i) {
    GLint size = 0;
    GLenum type = 0;
    char name[2];
    glGetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
    if (isSampler(type)) count += size;
  }
  return count;
}

}  // namespace

int textureUnits() {
  GLint units = 16;  // what OpenGL 3.2 promises
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  const char* fewer = std::getenv("BOXPROBE_TEXTURE_UNITS");
  const int asked = fewer != nullptr ? std::atoi(fewer) : 0;
  return asked > 0 ? std::min(asked, static_cast<int>(units)) : units;
}

bool programCompiles(vtkOpenGLRenderWindow* window, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment, bool quiet) {
  const int told = vtkObject::GetGlobalWarningDisplay();
  if (quiet) vtkObject::GlobalWarningDisplayOff();
  const ScopeExit toldAgain([told] { vtkObject::SetGlobalWarningDisplay(told); });
  // Separate shader objects: the cache modifies the sources it gets.
  vtkNew<vtkShader> vertexShader, geometryShader, fragmentShader;
  std::map<vtkShader::Type, vtkShader*> tried;
  const auto add = [&tried](vtkShader* shader, vtkShader::Type type, const std::string& source) {
    shader->SetType(type);
    shader->SetSource(source);
    tried[type] = shader;
  };
  add(vertexShader, vtkShader::Vertex, vertex);
  add(geometryShader, vtkShader::Geometry, geometry);
  add(fragmentShader, vtkShader::Fragment, fragment);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(tried);
  if (program == nullptr || !program->GetCompiled()) return false;
  return samplers(static_cast<GLuint>(program->GetHandle())) <= textureUnits();
}

}  // namespace boxprobe
