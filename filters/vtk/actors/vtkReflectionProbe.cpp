#include "filters/vtk/actors/vtkReflectionProbe.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <map>

#include "filters/core/scene/bounces.h"
#include "filters/core/scene/scene.h"

vtkStandardNewMacro(vtkReflectionProbe);

struct vtkReflectionProbe::TechniqueOfProbe {
  std::string id = boxprobe::Probe{}.technique;
  std::map<std::string, boxprobe::ParameterValue> parameters;
};

vtkReflectionProbe::vtkReflectionProbe() : Chosen(std::make_unique<TechniqueOfProbe>()) {}

vtkReflectionProbe::~vtkReflectionProbe() = default;

void vtkReflectionProbe::SetBounds(double xMin, double xMax, double yMin, double yMax, double zMin, double zMax) {
  const double bounds[6] = {xMin, xMax, yMin, yMax, zMin, zMax};
  this->SetBounds(bounds);
}

void vtkReflectionProbe::SetBounds(const double bounds[6]) {
  if (std::equal(bounds, bounds + 6, this->Bounds)) {
    return;
  }
  std::copy(bounds, bounds + 6, this->Bounds);
  if (this->OriginAtCenter) {
    for (int axis = 0; axis < 3; ++axis) {
      this->Origin[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    }
  }
  this->Modified();
}

void vtkReflectionProbe::SetOrigin(double x, double y, double z) {
  const double origin[3] = {x, y, z};
  this->SetOrigin(origin);
}

void vtkReflectionProbe::SetOrigin(const double origin[3]) {
  if (!this->OriginAtCenter && std::equal(origin, origin + 3, this->Origin)) {
    return;
  }
  this->OriginAtCenter = false;
  std::copy(origin, origin + 3, this->Origin);
  this->Modified();
}

void vtkReflectionProbe::SetOriginAtCenter(bool atCenter) {
  if (atCenter == this->OriginAtCenter) {
    return;
  }
  this->OriginAtCenter = atCenter;
  for (int axis = 0; atCenter && axis < 3; ++axis) {
    this->Origin[axis] = 0.5 * (this->Bounds[2 * axis] + this->Bounds[2 * axis + 1]);
  }
  this->Modified();
}

void vtkReflectionProbe::SetBlendDistance(double distance) {
  this->SetBlendDistances(distance, distance, distance, distance, distance, distance);
}

void vtkReflectionProbe::SetTechnique(const char* technique) {
  const std::string id = technique != nullptr ? technique : "";
  if (id == this->Chosen->id && this->Chosen->parameters.empty()) {
    return;
  }
  *this->Chosen = {id, {}};
  this->Modified();
}

const char* vtkReflectionProbe::GetTechnique() const {
  return this->Chosen->id.c_str();
}

void vtkReflectionProbe::SetTechniqueNumber(const char* parameter, double value) {
  if (parameter == nullptr) {
    vtkErrorMacro("SetTechniqueNumber: the parameter's name is null");
    return;
  }
  this->Chosen->parameters[parameter] = value;
  this->Modified();
}

void vtkReflectionProbe::SetTechniqueChoice(const char* parameter, const char* value) {
  if (parameter == nullptr || value == nullptr) {
    vtkErrorMacro("SetTechniqueChoice: the parameter's name or value is null");
    return;
  }
  this->Chosen->parameters[parameter] = std::string(value);
  this->Modified();
}

void vtkReflectionProbe::SetBouncesToAll() {
  this->SetBounces(boxprobe::kAllBounces);
}

boxprobe::Probe vtkReflectionProbe::ToProbe(const std::string& name) const {
  const auto box = [](const double* b) { return boxprobe::Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}}; };
  boxprobe::Probe probe;
  probe.name = name;
  probe.box = box(this->Bounds);
  probe.origin = {this->Origin[0], this->Origin[1], this->Origin[2]};
  probe.rotationDegrees = {this->Orientation[0], this->Orientation[1], this->Orientation[2]};
  if (this->UseInfluenceBounds) {
    probe.influence = box(this->InfluenceBounds);
  }
  const boxprobe::Box blend = box(this->BlendDistances);
  probe.blendDistance = {blend.min, blend.max};
  probe.importance = this->Importance;
  probe.intensity = this->Intensity;
  probe.technique = this->Chosen->id;
  probe.parameters = this->Chosen->parameters;
  probe.faceSize = this->FaceSize;
  probe.bounces = this->Bounces;
  probe.samplesPerPixel = this->SamplesPerPixel;
  // The libraries' defaults also mean distances derived from the box (ActorProbes).
  if (this->NearDistance != 0.0) {
    probe.nearDistance = this->NearDistance;
  }
  if (this->FarDistance != 0.0) {
    probe.farDistance = this->FarDistance;
  }
  if (this->Clear == OPEN) {
    probe.clear = boxprobe::ClearToOpen{};
  } else if (this->Clear == COLOR) {
    probe.clear = glm::vec3(this->ClearColor[0], this->ClearColor[1], this->ClearColor[2]);
  }
  return probe;
}

void vtkReflectionProbe::FromProbe(const boxprobe::Probe& probe) {
  const auto put = [](const glm::dvec3& low, const glm::dvec3& high, double* to) {
    for (int axis = 0; axis < 3; ++axis) {
      to[2 * axis] = low[axis];
      to[2 * axis + 1] = high[axis];
    }
  };
  const boxprobe::Probe standard;
  this->Name = probe.name;
  put(probe.box.min, probe.box.max, this->Bounds);
  put(probe.influenceBox().min, probe.influenceBox().max, this->InfluenceBounds);
  put(probe.blendDistance.min, probe.blendDistance.max, this->BlendDistances);
  this->UseInfluenceBounds = probe.influence.has_value();
  this->OriginAtCenter = probe.origin == probe.box.center();
  for (int axis = 0; axis < 3; ++axis) {
    this->Origin[axis] = probe.origin[axis];
    this->Orientation[axis] = probe.rotationDegrees[axis];
  }
  this->Importance = probe.importance;
  this->Intensity = probe.intensity;
  *this->Chosen = {probe.technique, probe.parameters};
  this->FaceSize = probe.faceSize;
  this->Bounces = probe.bounces;
  this->SamplesPerPixel = probe.samplesPerPixel;
  this->NearDistance = probe.nearDistance != standard.nearDistance ? probe.nearDistance : 0.0;
  this->FarDistance = probe.farDistance != standard.farDistance ? probe.farDistance : 0.0;
  this->Clear = SURROUNDINGS;
  if (std::holds_alternative<boxprobe::ClearToOpen>(probe.clear)) {
    this->Clear = OPEN;
  } else if (!std::holds_alternative<boxprobe::ClearToSky>(probe.clear)) {
    const auto* color = std::get_if<glm::vec3>(&probe.clear);
    this->Clear = COLOR;
    for (int i = 0; i < 3; ++i) {
      this->ClearColor[i] = color != nullptr ? static_cast<double>((*color)[i]) : 0.0;
    }
  }
  this->Modified();
}

void vtkReflectionProbe::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  const auto list = [&os, indent](const char* name, const double* values, int count) {
    os << indent << name << ":";
    for (int i = 0; i < count; ++i) {
      os << " " << values[i];
    }
    os << "\n";
  };
  os << indent << "Name: " << this->Name << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  list("Bounds", this->Bounds, 6);
  list("Origin", this->Origin, 3);
  os << indent << "OriginAtCenter: " << this->OriginAtCenter << "\n";
  list("Orientation", this->Orientation, 3);
  list("InfluenceBounds", this->InfluenceBounds, 6);
  os << indent << "UseInfluenceBounds: " << this->UseInfluenceBounds << "\n";
  list("BlendDistances", this->BlendDistances, 6);
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "Intensity: " << this->Intensity << "\n";
  os << indent << "Technique: " << this->Chosen->id << " (" << this->Chosen->parameters.size() << " parameters set)\n";
  os << indent << "FaceSize: " << this->FaceSize << "\n";
  os << indent << "Bounces: " << this->Bounces << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "NearDistance: " << this->NearDistance << "\n";
  os << indent << "FarDistance: " << this->FarDistance << "\n";
  os << indent << "Clear: " << this->Clear << "\n";
  list("ClearColor", this->ClearColor, 3);
}
