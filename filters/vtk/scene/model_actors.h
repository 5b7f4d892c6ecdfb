// A model's instances as VTK actors: geometry, physically based properties, textures. Material and object overrides are
// applied again without rebuilding geometry.
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
  Material material;  ///< as in the model, before overrides
  bool unlit = false;
  bool allMetal = false;  ///< after overrides: no diffuse reflection anywhere
  /// Range of the roughness of its surface, including a clear coat, after overrides.
  double roughnessMin = 0.0, roughnessMax = 1.0;
  double textureRoughnessMin = 1.0, textureRoughnessMax = 1.0;  ///< factors of the material's roughness, from a texture
  glm::dmat4 placed{1.0};                                       ///< by its model's entry
  glm::dmat4 worldFromModel{1.0};                               ///< including the movement of its override
  std::shared_ptr<SurfaceMaterial> surface;                     ///< its values follow the overrides
  const Mesh* mesh = nullptr;                                   ///< owned by the model, which has the same lifetime
  vtkSmartPointer<vtkActor> actor;
  std::optional<Box> placedBounds;     ///< world; replaces the actor's own for a part that an assembly places
  vtkSmartPointer<vtkProbePass> pass;  ///< lights the actor
  ObjectOverride settings;
};

/// The objects of one model. Textures and vertex data are shared between its instances.
std::vector<DrawnObject> makeObjects(const Model& model, const ModelFile& placement,
                                     const std::shared_ptr<DrawState>& state);

/// An actor that shares geometry, property and textures with the object's, but has another program.
vtkSmartPointer<vtkProbeActor> makeTwin(const DrawnObject& object, std::shared_ptr<DrawState> state);

/// Moves an object according to its model's current entry.
void placeObject(DrawnObject& object, const Instance& instance, const ModelFile& placement);

/// Applies the material and object overrides of `scene` to an object.
void applyOverrides(DrawnObject& object, const Scene& scene);

/// World bounds of an object in double.
Box worldBounds(const DrawnObject& object);

}  // namespace boxprobe
