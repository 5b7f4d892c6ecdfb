#include "tests/vtk/shader_text.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkShader.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <fstream>

#include "filters/core/base/errors.h"

namespace boxprobe::test {

namespace {

constexpr const char* kVertex = "//--- vertex";
constexpr const char* kGeometry = "//--- geometry";
constexpr const char* kFragment = "//--- fragment";

// Keeps what the superclass has written.
class TextMapper : public vtkOpenGLPolyDataMapper {
 public:
  static TextMapper* New();
  vtkTypeMacro(TextMapper, vtkOpenGLPolyDataMapper) ShaderSources Text;

 protected:
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override {
    this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
    this->Text = {shaders[vtkShader::Vertex]->GetSource(), shaders[vtkShader::Geometry]->GetSource(),
                  shaders[vtkShader::Fragment]->GetSource()};
  }
};

vtkStandardNewMacro(TextMapper);

// One object drawn, by a renderer that `prepare` may change.
template <typename Prepare>
ShaderSources drawn(vtkRenderWindow* window, vtkPolyData* data, Prepare prepare) {
  vtkNew<TextMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPBR();
  vtkNew<vtkOpenGLRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  renderer->AddActor(actor);
  prepare(renderer.Get(), actor->GetProperty());
  window->AddRenderer(renderer);
  window->Render();
  window->RemoveRenderer(renderer);
  return mapper->Text;
}

vtkSmartPointer<vtkLight> light(bool positional) {
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(positional);
  light->SetConeAngle(40.0);
  light->SetPosition(0.0, 0.0, 2.0);
  return light;
}

}  // namespace

ShaderSources readText(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file + ": cannot be read");
  ShaderSources text;
  std::string* part = nullptr;
  for (std::string line; std::getline(in, line);) {
    if (line == kVertex) {
      part = &text.vertex;
    } else if (line == kGeometry) {
      part = &text.geometry;
    } else if (line == kFragment) {
      part = &text.fragment;
    } else if (part != nullptr) {
      *part += line + "\n";
    }
  }
  return text;
}

void writeText(const std::string& file, const ShaderSources& text) {
  std::ofstream out(file);
  out << kVertex << "\n" << text.vertex;
  if (!text.geometry.empty()) out << "\n" << kGeometry << "\n" << text.geometry;
  out << "\n" << kFragment << "\n" << text.fragment << "\n";
  if (!out.flush()) throw WorkError(file + ": cannot be written");
}

std::map<std::string, ShaderSources> runningText(vtkRenderWindow* window) {
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  std::map<std::string, ShaderSources> texts;
  texts["lamps"] = drawn(window, plane->GetOutput(), [](vtkRenderer* renderer, vtkProperty* property) {
    renderer->AddLight(light(false));
    renderer->AddLight(light(true));
    property->SetCoatStrength(0.5);
    property->EdgeVisibilityOn();
  });
  vtkNew<vtkPolyData> colored;
  colored->DeepCopy(plane->GetOutput());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(colored->GetNumberOfPoints());
  colors->Fill(200.0);
  colored->GetPointData()->SetScalars(colors);
  texts["surroundings"] = drawn(window, colored, [](vtkOpenGLRenderer* renderer, vtkProperty*) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(64, 32, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    image->GetPointData()->GetScalars()->Fill(1.0);
    vtkNew<vtkTexture> sky;
    sky->SetInputData(image);
    sky->MipmapOn();
    sky->InterpolateOn();
    sky->SetColorModeToDirectScalars();
    renderer->UseImageBasedLightingOn();
    renderer->UseSphericalHarmonicsOff();
    renderer->SetEnvironmentTexture(sky);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(4);
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(1);
    renderer->GetEnvMapLookupTable()->SetLUTSize(8);
    renderer->GetEnvMapLookupTable()->SetLUTSamples(1);
    vtkNew<vtkLight> headlight;
    headlight->SetLightTypeToHeadlight();
    renderer->AddLight(headlight);
  });
  vtkNew<vtkLineSource> line;
  line->Update();
  texts["lines"] =
      drawn(window, line->GetOutput(), [](vtkRenderer* renderer, vtkProperty*) { renderer->AddLight(light(false)); });
  return texts;
}

}  // namespace boxprobe::test
