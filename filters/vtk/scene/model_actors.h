// A model's instances as VTK actors: geometry, physically based properties, textures. Called by the scene renderer when
// the models change; material and object overrides are applied again, without rebuilding geometry, when they change.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/surface/vtkProbeActor.h"

namespace boxprobe {

/// One drawn object.
struct DrawnObject {
  std::string node;
  std::string materialName;
  Material material;  ///< as the model has it, before overrides
  bool unlit = false;
  bool allMetal = false;  ///< after overrides: no diffuse reflection anywhere
  /// Smallest and largest roughness of its surface, a clear coat's included, after overrides.
  double roughnessMin = 0.0, roughnessMax = 1.0;
  double textureRoughnessMin = 1.0, textureRoughnessMax = 1.0;  ///< what a texture multiplies the material's by
  glm::dmat4 placed{1.0};                                       ///< by its model's entry
  glm::dmat4 worldFromModel{1.0};                               ///< moved by its override, too
  std::shared_ptr<SurfaceMaterial> surface;                     ///< its numbers follow the overrides
  const Mesh* mesh = nullptr;                                   ///< of the model, which lives as long
  vtkSmartPointer<vtkActor> actor;
  std::optional<Box> placedBounds;     ///< world; in place of the actor's own: of a part that an assembly places
  vtkSmartPointer<vtkProbePass> pass;  ///< that lights the actor
  ObjectOverride settings;
};

/// Objects of one model. Texture objects and vertex data are shared between its instances.
std::vector<DrawnObject> makeObjects(const Model& model, const ModelFile& placement,
                                     const std::shared_ptr<DrawState>& state);

/// An actor that shares geometry, property and textures with the object's; only the program is another one.
vtkSmartPointer<vtkProbeActor> makeTwin(const DrawnObject& object, std::shared_ptr<DrawState> state);

/// Moves an object to where its model's entry puts it now.
void placeObject(DrawnObject& object, const Instance& instance, const ModelFile& placement);

/// Material and object overrides of `scene` on an object.
void applyOverrides(DrawnObject& object, const Scene& scene);

/// World bounds of an object in double.
Box worldBounds(const DrawnObject& object);

}  // namespace boxprobe
