#include "filters/vtk/placement/vtkReflectionProbeFit.h"

#include <vtkActor.h>
#include <vtkAssemblyPath.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <functional>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/fit/fit_probe.h"
#include "filters/fit/place_probes.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"

vtkStandardNewMacro(vtkReflectionProbeFit);

namespace {

/// Converts between the renderer's axes and units and those of the fit, metres with +y up: a cyclic permutation of
/// axes, which does not mirror, and a scale.
struct Frame {
  int up = 1;
  double metres = 1.0;

  int axisOf(int fitAxis) const { return (up + 2 + fitAxis) % 3; }
  glm::dvec3 toFit(const glm::dvec3& v, double scale) const {
    return scale * glm::dvec3(v[axisOf(0)], v[axisOf(1)], v[axisOf(2)]);
  }
  glm::dvec3 fromFit(const glm::dvec3& v, double scale) const {
    glm::dvec3 out;
    for (int i = 0; i < 3; ++i) out[axisOf(i)] = scale * v[i];
    return out;
  }

  boxprobe::Probe changed(const boxprobe::Probe& probe, bool to) const {
    const auto vector = [&](const glm::dvec3& v, double scale) { return to ? toFit(v, scale) : fromFit(v, scale); };
    const double scale = to ? metres : 1.0 / metres;
    const auto box = [&](const boxprobe::Box& b) { return boxprobe::Box{vector(b.min, scale), vector(b.max, scale)}; };
    boxprobe::Probe out = probe;
    out.origin = vector(probe.origin, scale);
    out.box = box(probe.box);
    if (probe.influence) out.influence = box(*probe.influence);
    out.blendDistance = {vector(probe.blendDistance.min, scale), vector(probe.blendDistance.max, scale)};
    out.rotationDegrees = vector(probe.rotationDegrees, 1.0);
    const boxprobe::Probe standard;
    if (probe.nearDistance != standard.nearDistance) out.nearDistance = scale * probe.nearDistance;
    if (probe.farDistance != standard.farDistance) out.farDistance = scale * probe.farDistance;
    return out;
  }
};

struct Shown {
  boxprobe::Scene scene;
  boxprobe::TriangleRays::Models models;
};

void addActor(boxprobe::Model& model, vtkActor* actor, vtkMatrix4x4* matrix, const Frame& frame,
              const std::string& name) {
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  if (mapper == nullptr || actor->GetVisibility() == 0) {
    return;
  }
  mapper->Update();
  if (mapper->GetInput() == nullptr) {
    return;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mapper->GetInput());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkPolyData* data = triangles->GetOutput();
  boxprobe::Mesh mesh;
  mesh.name = name;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[4] = {0.0, 0.0, 0.0, 1.0}, world[4];
    data->GetPoint(i, p);
    matrix->MultiplyPoint(p, world);
    mesh.positions.emplace_back(frame.toFit(glm::dvec3(world[0], world[1], world[2]), frame.metres));
  }
  const auto cell = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    for (vtkIdType k = 0; count == 3 && k < 3; ++k) {
      mesh.indices.push_back(static_cast<std::uint32_t>(ids[k]));
    }
  }
  if (mesh.indices.empty()) {
    return;
  }
  vtkProperty* property = actor->GetProperty();
  const double* color = property->GetColor();
  boxprobe::Material material;
  material.name = name;
  material.baseColor = glm::vec4(color[0], color[1], color[2], property->GetOpacity());
  material.metallic = static_cast<float>(property->GetMetallic());
  material.roughness = static_cast<float>(property->GetRoughness());
  material.unlit = property->GetInterpolation() != VTK_PBR || !property->GetLighting();
  if (property->GetOpacity() < 1.0) {
    material.alphaMode = boxprobe::AlphaMode::Blend;
  }
  mesh.material = static_cast<int>(model.materials.size());
  model.materials.push_back(std::move(material));
  model.instances.push_back({name, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
  model.meshes.push_back(std::move(mesh));
}

Shown shownBy(vtkReflectionProbes* probes, const Frame& frame) {
  Shown shown;
  boxprobe::Model model;
  std::set<vtkProp*> taken;
  const auto add = [&](vtkProp* prop, vtkProp* owner, vtkMatrix4x4* matrix) {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor == nullptr || vtkSkybox::SafeDownCast(prop) != nullptr || !probes->GetUsed(actor) ||
        !probes->GetUsed(owner) || owner->GetVisibility() == 0) {
      return;
    }
    const std::string name = "actor " + std::to_string(model.instances.size());
    addActor(model, actor, matrix, frame, name);
    if (!probes->GetSeenByProbes(actor) || !probes->GetSeenByProbes(owner)) {
      shown.scene.objects[name].seenByProbes = false;
    }
  };
  vtkPropCollection* props = probes->GetRenderer()->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it)) {
    if (prop->IsA("vtkAssembly") == 0) {
      if (auto* actor = vtkActor::SafeDownCast(prop)) {
        add(prop, prop, actor->GetMatrix());
      }
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath()) {
      add(path->GetLastNode()->GetViewProp(), prop, path->GetLastNode()->GetMatrix());
    }
  }
  shown.scene.models.push_back({"renderer"});
  shown.models.push_back(std::make_shared<const boxprobe::Model>(std::move(model)));
  return shown;
}

bool turnsAboutUpAlone(const boxprobe::Probe& probe) {
  return probe.rotationDegrees.x == 0.0 && probe.rotationDegrees.z == 0.0;
}

}  // namespace

struct vtkReflectionProbeFit::Parts {
  vtkSmartPointer<vtkReflectionProbes> probes;
};

vtkReflectionProbeFit::vtkReflectionProbeFit() : Inside(std::make_unique<Parts>()) {}

vtkReflectionProbeFit::~vtkReflectionProbeFit() = default;

void vtkReflectionProbeFit::SetProbes(vtkReflectionProbes* probes) {
  if (probes == this->Inside->probes) {
    return;
  }
  this->Inside->probes = probes;
  this->Modified();
}

vtkReflectionProbes* vtkReflectionProbeFit::GetProbes() const {
  return this->Inside->probes;
}

bool vtkReflectionProbeFit::Fit(vtkReflectionProbe* probe) {
  this->Report.clear();
  this->AbortFlag = false;
  vtkReflectionProbes* probes = this->Inside->probes;
  if (probe == nullptr || probes == nullptr || probes->GetRenderer() == nullptr) {
    vtkErrorMacro("Fit: " << (probe == nullptr ? "the probe is null" : "there is no renderer; call SetProbes() first"));
    return false;
  }
  const Frame frame{this->UpAxis, this->MetresPerUnit};
  const std::string name = probe->GetName() != nullptr ? probe->GetName() : "";
  const boxprobe::Probe given = frame.changed(probe->ToProbe(name), true);
  if (!turnsAboutUpAlone(given)) {
    vtkErrorMacro("Fit: the probe is turned about another axis than UpAxis; nothing is fitted");
    return false;
  }
  try {
    const Shown shown = shownBy(probes, frame);
    boxprobe::BoxFitSettings settings;
    settings.yaw = this->Turning;
    settings.rays = this->NumberOfRays;
    boxprobe::ProbeFitter fitter(shown.scene, shown.models);
    const auto fit = fitter.fit(given, settings, [this](double done) {
      this->InvokeEvent(vtkCommand::ProgressEvent, &done);
      return !this->AbortFlag;
    });
    if (!fit) {
      this->Report = "stopped; the probe is as it was\n";
      return false;
    }
    for (const std::string& remark : boxprobe::english(fit->remarks)) {
      this->Report += remark + "\n";
    }
    if (fit->outcome != boxprobe::FitOutcome::Fitted) {
      return false;
    }
    boxprobe::Probe fitted = frame.changed(fit->probe, false);
    fitted.name = name;
    probe->FromProbe(fitted);
    return true;
  } catch (const std::exception& failure) {
    vtkErrorMacro(<< boxprobe::messageOf(failure));
    return false;
  }
}

int vtkReflectionProbeFit::Place(int most) {
  this->Report.clear();
  this->AbortFlag = false;
  vtkReflectionProbes* probes = this->Inside->probes;
  if (probes == nullptr || probes->GetRenderer() == nullptr) {
    vtkErrorMacro("Place: there is no renderer; call SetProbes() first");
    return -1;
  }
  const Frame frame{this->UpAxis, this->MetresPerUnit};
  try {
    Shown shown = shownBy(probes, frame);
    for (int i = 0; i < probes->GetNumberOfProbes(); ++i) {
      const boxprobe::Probe there = frame.changed(probes->GetProbe(i)->ToProbe("probe " + std::to_string(i)), true);
      shown.scene.probes.push_back(there);
    }
    boxprobe::PlaceSettings settings;
    settings.most = static_cast<std::size_t>(std::max(most, 0));
    settings.keep = true;
    settings.rays = this->NumberOfRays;
    const auto onward = [this](double done) {
      this->InvokeEvent(vtkCommand::ProgressEvent, &done);
      return !this->AbortFlag;
    };
    auto placed = boxprobe::placeProbes(shown.scene, shown.models, settings, onward);
    if (placed && placed->rooms.empty()) {  // walls may show back faces: VTK draws both
      settings.inverted = true;
      placed = boxprobe::placeProbes(shown.scene, shown.models, settings, onward);
    }
    if (!placed) {
      this->Report = "stopped; nothing was placed\n";
      return 0;
    }
    for (const boxprobe::PlacedRoom& room : placed->rooms) {
      for (const std::string& decision : boxprobe::english(room.decisions)) {
        this->Report += decision + "\n";
      }
    }
    for (const std::string& remark : boxprobe::english(placed->remarks)) {
      this->Report += remark + "\n";
    }
    for (const boxprobe::PlacedProbe& each : placed->probes) {
      vtkNew<vtkReflectionProbe> probe;
      probe->FromProbe(frame.changed(each.probe, false));
      probes->AddProbe(probe);
    }
    return static_cast<int>(placed->probes.size());
  } catch (const std::exception& failure) {
    vtkErrorMacro(<< boxprobe::messageOf(failure));
    return -1;
  }
}

void vtkReflectionProbeFit::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Probes: " << this->Inside->probes.Get() << "\n";
  os << indent << "UpAxis: " << this->UpAxis << "\n";
  os << indent << "MetresPerUnit: " << this->MetresPerUnit << "\n";
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "Turning: " << this->Turning << "\n";
  os << indent << "AbortFlag: " << this->AbortFlag << "\n";
  os << indent << "Report: " << this->Report << "\n";
}
