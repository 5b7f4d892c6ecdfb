#include "filters/vtk/gl/program_check.h"

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <map>

#include "filters/core/base/scope_exit.h"

namespace boxprobe {

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
  return program != nullptr && program->GetCompiled();
}

}  // namespace boxprobe
