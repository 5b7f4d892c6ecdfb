#include "filters/vtk/inspect/preview_sphere.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <glm/matrix.hpp>

#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

constexpr int kAround = 96, kUpDown = 48;  ///< facets: a mirror's outline must look round

}  // namespace

PreviewSphere::PreviewSphere(vtkRenderWindow* window, vtkRenderer* scene, std::shared_ptr<DrawState> state)
    : window_(window), scene_(scene), state_(std::move(state)) {}

PreviewSphere::~PreviewSphere() {
  if (layer_ != nullptr) window_->RemoveRenderer(layer_);
}

double PreviewSphere::radius(const Box& box) {
  double shortest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double edge = box.size()[axis];
    if (edge > 0.0 && (shortest == 0.0 || edge < shortest)) shortest = edge;
  }
  return shortest > 0.0 ? 0.1 * shortest : 0.1;
}

void PreviewSphere::build() {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(kAround);
  sphere->SetPhiResolution(kUpDown);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  actor_ = vtkSmartPointer<vtkProbeActor>::New();
  actor_->SetMapper(mapper);
  actor_->GetPass()->SetDrawState(state_);
  actor_->GetProperty()->SetInterpolationToPBR();
  actor_->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor_->GetProperty()->SetEmissiveFactor(0.0, 0.0, 0.0);  // VTK's default is white

  layer_ = vtkSmartPointer<vtkRenderer>::New();
  window_->SetNumberOfLayers(std::max(window_->GetNumberOfLayers(), 2));
  layer_->SetLayer(1);
  layer_->InteractiveOff();
  layer_->PreserveDepthBufferOn();
  // Lit by the maps alone; but without any light VTK would not shade at all.
  layer_->AutomaticLightCreationOff();
  vtkNew<vtkLight> dark;
  dark->SetIntensity(0.0);
  layer_->AddLight(dark);
  layer_->AddActor(actor_);
}

void PreviewSphere::applyMaterial() {
  vtkProperty* property = actor_->GetProperty();
  const bool diffuse = settings_.kind == SphereKind::Diffuse;
  property->SetMetallic(diffuse ? 0.0 : 1.0);
  property->SetRoughness(settings_.kind == SphereKind::Chrome ? 0.0 : diffuse ? 1.0 : settings_.roughness);
  // An index of 1 has no specular reflection: irradiance only.
  property->SetBaseIOR(diffuse ? 1.0 : 1.5);

  drawn_->geometry.technique = parseTechnique("infinite").value_or(Technique{});
  auto binding = std::make_shared<ProbeBinding>();
  binding->lighting = Lighting::Probes;
  binding->probes = {drawn_};
  binding->weights = false;
  binding->sky = false;
  binding->diffuse = diffuse;
  actor_->GetPass()->SetBinding(std::move(binding));
}

void PreviewSphere::show(const PreviewSphereSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  if (shown()) {
    if (layer_ == nullptr) build();
    if (!window_->HasRenderer(layer_)) window_->AddRenderer(layer_);
    applyMaterial();
  } else if (layer_ != nullptr) {
    window_->RemoveRenderer(layer_);
    drawn_->maps.reset();
  }
}

void PreviewSphere::release() {
  show({});
  if (actor_ != nullptr) actor_->ReleaseGraphicsResources(window_);
}

LevelMask PreviewSphere::sampled(const ProbeMaps& maps) const {
  const double roughness = actor_->GetProperty()->GetRoughness();
  return levelsRead(drawn_->geometry.technique, drawn_->geometry.parameters, roughness, roughness,
                    maps.radiance.levels());
}

void PreviewSphere::follow(const Probe* probe, const std::shared_ptr<const ProbeMaps>& maps) {
  if (!shown()) return;
  actor_->SetVisibility(probe != nullptr && maps != nullptr);
  if (probe == nullptr || maps == nullptr) return;
  drawn_->maps = maps;
  drawn_->geometry.originWorld = probe->origin;
  const bool turned = maps->capturedRotation != glm::dvec3(0.0);
  drawn_->geometry.mapFromProbe = turned ? glm::transpose(rotationMatrix(maps->capturedRotation)) : glm::dmat3(1.0);
  if (turned != drawn_->geometry.mapTurned) {
    drawn_->geometry.mapTurned = turned;
    applyMaterial();  // selects another program
  }
  drawn_->geometry.intensity = static_cast<float>(probe->intensity);
  actor_->SetPosition(probe->origin.x, probe->origin.y, probe->origin.z);
  actor_->SetScale(radius(probe->box));
  // The same camera, so that depths of the two pictures can be compared.
  if (layer_->GetActiveCamera() != scene_->GetActiveCamera()) layer_->SetActiveCamera(scene_->GetActiveCamera());
}

}  // namespace boxprobe
