#include "filters/vtk/rays/vtkProjectionRays.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "filters/core/geometry/light_shadow.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/openings.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/rays/ray_builder.h"
#include "filters/vtk/rays/ray_scene.h"

vtkStandardNewMacro(vtkProjectionRays);

namespace boxprobe {

/// A probe of the filter. Not in the unnamed namespace, because it is a type of the filter's members.
struct FilterProbe {
  Probe probe;
  std::optional<double> maximumLevel;
  std::optional<glm::dvec3> capturedAt;
  glm::dvec3 capturedRotation{0.0};
  std::shared_ptr<const CubeMap> distances;
  LazyRelief relief;  // of the distances
  std::shared_ptr<const CubeMap> coverage;
};

}  // namespace boxprobe

namespace {

using namespace boxprobe;

RayProbe rayProbe(const FilterProbe& p, const std::vector<Light>& lights) {
  RayProbe result;
  result.name = p.probe.name;
  result.geometry = probeGeometry(p.probe, p.capturedAt.value_or(p.probe.origin), p.capturedRotation);
  result.maxLevel = static_cast<float>(p.maximumLevel.value_or(prefilterLevels(p.probe.faceSize) - 1));
  result.distances = p.distances;
  result.relief = p.relief;
  result.coverage = p.coverage;
  for (std::size_t i = 0; i < std::min(lights.size(), kMostShadowLights); ++i) {
    if (lights[i].shadows != LightShadows::None && lightOutside(lights[i], p.probe)) result.shadowLights |= 1u << i;
  }
  return result;
}

bool allFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

struct vtkProjectionRays::Internals {
  std::vector<FilterProbe> probes;
  std::vector<Light> lights;
  std::array<bool, kRayKinds> kinds{};
  std::vector<RayGlass> glass;
  // Kept between executions while the scene is the same, because its search structure is expensive.
  std::unique_ptr<RayScene> scene;
  vtkPolyData* sceneData = nullptr;
  vtkMTimeType sceneTime = 0;

  void useScene(vtkPolyData* data);
};

void vtkProjectionRays::Internals::useScene(vtkPolyData* data) {
  if (data == sceneData && (data == nullptr || data->GetMTime() == sceneTime)) return;
  sceneData = data;
  sceneTime = data == nullptr ? 0 : data->GetMTime();
  scene = data == nullptr ? nullptr : std::make_unique<RayScene>(data);
}

vtkProjectionRays::vtkProjectionRays() : Internal(std::make_unique<Internals>()) {
  this->SetNumberOfInputPorts(2);
  this->Internal->kinds.fill(true);
}

vtkProjectionRays::~vtkProjectionRays() = default;

int vtkProjectionRays::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkProjectionRays::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) {
  vtkPointSet* points = vtkPointSet::GetData(input[0]);
  Internals& d = *this->Internal;
  d.useScene(vtkPolyData::GetData(input[1]));
  RayBuilderSettings settings;
  settings.view = {this->ParallelProjection != 0,
                   {this->Eye[0], this->Eye[1], this->Eye[2]},
                   {this->ViewDirection[0], this->ViewDirection[1], this->ViewDirection[2]}};
  if (!allFinite(settings.view.parallel ? settings.view.viewDirection : settings.view.eyeWorld)) {
    vtkErrorMacro("the eye or the view direction is not a finite number");
    return 0;
  }
  std::vector<std::string> names;
  for (const FilterProbe& probe : d.probes) {
    settings.probes.push_back(rayProbe(probe, d.lights));
    names.push_back(probe.probe.name);
  }
  settings.kinds = d.kinds;
  settings.lights = d.lights;
  settings.maximumLength = this->MaximumLength;
  settings.normalLength = this->NormalLength;
  settings.contributingOnly = this->ContributingProbesOnly != 0;
  settings.scene = d.scene.get();

  RayLines lines;
  RayBuilder builder(settings, lines);
  vtkDataArray* normals = points->GetPointData()->GetNormals();
  if (normals == nullptr) normals = points->GetPointData()->GetArray("Normals");
  vtkDataArray* roughness = points->GetPointData()->GetArray("roughness");
  vtkDataArray* glass = points->GetPointData()->GetArray("glass");
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkIdType kept = std::min<vtkIdType>(count, this->MaximumNumberOfRays);
  for (vtkIdType i = 0; i < kept && !this->GetAbortExecute(); ++i) {
    const vtkIdType id = i * count / kept;  // evenly distributed over all points
    glm::dvec3 position(0.0), normal(0.0);
    points->GetPoint(id, &position.x);
    if (!allFinite(position)) continue;
    if (normals != nullptr && normals->GetNumberOfComponents() == 3) normals->GetTuple(id, &normal.x);
    const auto p = static_cast<float>(roughness != nullptr ? roughness->GetComponent(id, 0) : 0.0);
    const SurfaceRay ray = surfaceRay(position, normal, p, settings.view);
    builder.addPoint(static_cast<int>(id), ray);
    const int code = glass != nullptr ? static_cast<int>(glass->GetComponent(id, 0)) : -1;
    if (code >= 0 && static_cast<std::size_t>(code / 2) < d.glass.size()) {
      builder.addGlass(static_cast<int>(id), ray, d.glass[static_cast<std::size_t>(code / 2)].surface, code % 2 == 1);
    }
  }
  lines.writeTo(vtkPolyData::GetData(output), names);
  return 1;
}

void vtkProjectionRays::SetSceneData(vtkPolyData* scene) {
  this->SetInputDataInternal(1, scene);
}

void vtkProjectionRays::SetGlass(std::vector<RayGlass> glass) {
  this->Internal->glass = std::move(glass);
  this->Modified();
}

void vtkProjectionRays::SetKindEnabled(RayKind kind, bool enabled) {
  bool& current = this->Internal->kinds[static_cast<std::size_t>(kind)];
  if (current == enabled) return;
  current = enabled;
  this->Modified();
}

bool vtkProjectionRays::GetKindEnabled(RayKind kind) const {
  return this->Internal->kinds[static_cast<std::size_t>(kind)];
}

int vtkProjectionRays::GetNumberOfProbes() const {
  return static_cast<int>(this->Internal->probes.size());
}

int vtkProjectionRays::AddProbe() {
  return this->AddProbe(Probe{});
}

int vtkProjectionRays::AddProbe(const Probe& probe, double maximumLevel) {
  FilterProbe added;
  added.probe = probe;
  if (maximumLevel >= 0.0) added.maximumLevel = maximumLevel;
  this->Internal->probes.push_back(std::move(added));
  this->Modified();
  return this->GetNumberOfProbes() - 1;
}

void vtkProjectionRays::SetProbes(const std::vector<Probe>& probes) {
  this->RemoveAllProbes();
  for (const Probe& probe : probes) this->AddProbe(probe);
}

void vtkProjectionRays::RemoveAllProbes() {
  this->Internal->probes.clear();
  this->Modified();
}

// The probe to change; null after an error: no probe of that index, or an invalid value.
Probe* vtkProjectionRays::EditProbe(int index, bool valid) {
  if (index < 0 || index >= this->GetNumberOfProbes()) {
    vtkErrorMacro("there is no probe " << index << ": " << this->GetNumberOfProbes() << " have been added");
    return nullptr;
  }
  if (!valid) {
    vtkErrorMacro("probe " << index << ": a value is not finite or out of range (a minimum above its maximum?)");
    return nullptr;
  }
  this->Modified();
  return &this->Internal->probes[static_cast<std::size_t>(index)].probe;
}

namespace {

bool validBox(const Box& box) {
  return allFinite(box.min) && allFinite(box.max) && glm::all(glm::lessThanEqual(box.min, box.max));
}

}  // namespace

void vtkProjectionRays::SetProbeName(int index, const char* name) {
  if (Probe* probe = this->EditProbe(index, name != nullptr)) probe->name = name;
}

void vtkProjectionRays::SetProbeOrigin(int index, double x, double y, double z) {
  const glm::dvec3 origin(x, y, z);
  if (Probe* probe = this->EditProbe(index, allFinite(origin))) probe->origin = origin;
}

void vtkProjectionRays::SetProbeBounds(int index, double xMin, double xMax, double yMin, double yMax, double zMin,
                                       double zMax) {
  const Box box{{xMin, yMin, zMin}, {xMax, yMax, zMax}};
  if (Probe* probe = this->EditProbe(index, validBox(box))) probe->box = box;
}

void vtkProjectionRays::SetProbeInfluence(int index, double xMin, double xMax, double yMin, double yMax, double zMin,
                                          double zMax) {
  const Box box{{xMin, yMin, zMin}, {xMax, yMax, zMax}};
  if (Probe* probe = this->EditProbe(index, validBox(box))) probe->influence = box;
}

void vtkProjectionRays::SetProbeRotation(int index, double xDegrees, double yDegrees, double zDegrees) {
  const glm::dvec3 rotation(xDegrees, yDegrees, zDegrees);
  if (Probe* probe = this->EditProbe(index, allFinite(rotation))) probe->rotationDegrees = rotation;
}

void vtkProjectionRays::SetProbeBlendDistance(int index, double distance) {
  if (Probe* probe = this->EditProbe(index, std::isfinite(distance) && distance >= 0.0)) {
    probe->blendDistance = {glm::dvec3(distance), glm::dvec3(distance)};
  }
}

void vtkProjectionRays::SetProbeImportance(int index, double importance) {
  if (Probe* probe = this->EditProbe(index, std::isfinite(importance))) probe->importance = importance;
}

void vtkProjectionRays::SetProbeTechnique(int index, const char* id) {
  if (id == nullptr || !parseTechnique(id)) {
    vtkErrorMacro("technique \"" << (id == nullptr ? "" : id) << "\": known are " << techniqueIdList());
    return;
  }
  if (Probe* probe = this->EditProbe(index, true)) probe->technique = id;
}

void vtkProjectionRays::SetProbeMaximumLevel(int index, double level) {
  if (this->EditProbe(index, std::isfinite(level) && level >= 0.0) != nullptr) {
    this->Internal->probes[static_cast<std::size_t>(index)].maximumLevel = level;
  }
}

void vtkProjectionRays::SetProbeCapturedAt(int index, double x, double y, double z) {
  const glm::dvec3 origin(x, y, z);
  if (this->EditProbe(index, allFinite(origin)) != nullptr) {
    this->Internal->probes[static_cast<std::size_t>(index)].capturedAt = origin;
  }
}

void vtkProjectionRays::SetProbeCapturedRotation(int index, double xDegrees, double yDegrees, double zDegrees) {
  const glm::dvec3 degrees(xDegrees, yDegrees, zDegrees);
  if (this->EditProbe(index, allFinite(degrees)) != nullptr) {
    this->Internal->probes[static_cast<std::size_t>(index)].capturedRotation = degrees;
  }
}

void vtkProjectionRays::SetProbeDistances(int index, std::shared_ptr<const CubeMap> distances) {
  if (this->EditProbe(index, true) == nullptr) return;
  this->Internal->probes[static_cast<std::size_t>(index)].distances = std::move(distances);
  this->Internal->probes[static_cast<std::size_t>(index)].relief = {};
}

void vtkProjectionRays::SetProbeCoverage(int index, const CubeMap& radiance) {
  if (this->EditProbe(index, true) == nullptr) return;
  this->Internal->probes[static_cast<std::size_t>(index)].coverage =
      std::make_shared<const CubeMap>(throughChain(radiance));
}

void vtkProjectionRays::SetLights(const std::vector<Light>& lights) {
  if (this->Internal->lights == lights) return;
  this->Internal->lights = lights;
  this->Modified();
}

void vtkProjectionRays::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Eye: " << this->Eye[0] << " " << this->Eye[1] << " " << this->Eye[2] << "\n";
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1] << " "
     << this->ViewDirection[2] << "\n";
  os << indent << "MaximumNumberOfRays: " << this->MaximumNumberOfRays << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "NormalLength: " << this->NormalLength << "\n";
  os << indent << "ContributingProbesOnly: " << this->ContributingProbesOnly << "\n";
  os << indent << "Kinds:";
  for (std::size_t i = 0; i < kRayKinds; ++i) {
    if (this->Internal->kinds[i]) os << " \"" << kRayKindNames[i] << "\"";
  }
  os << "\n";
  for (const FilterProbe& p : this->Internal->probes) {
    os << indent << "Probe: \"" << p.probe.name << "\", technique " << p.probe.technique << ", distances "
       << (p.distances ? "known" : "not known") << "\n";
  }
}
