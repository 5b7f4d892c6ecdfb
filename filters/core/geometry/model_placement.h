// Where a model file's frame lies in the world, and the values of the file that become part of a scene.
#pragma once

#include <glm/mat4x4.hpp>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Units and up axis, then the scale, rotation and translation of a scene's model entry.
glm::dmat4 worldFromFile(const ModelFile& file);

/// The transform of an instance that its model places at `placed`: rotated about its node's own origin and moved as the
/// scene says.
glm::dmat4 movedInstance(const glm::dmat4& placed, const ObjectOverride& object);
/// The same, by the node's name.
glm::dmat4 movedInstance(const glm::dmat4& placed, const Scene& scene, const std::string& node);

/// Metres of one unit.
double metresPerUnit(LengthUnit unit);

/// The model's lights and cameras, placed as `file` says.
std::vector<Light> placedLights(const Model& model, const ModelFile& file);
std::vector<Camera> placedCameras(const Model& model, const ModelFile& file);

}  // namespace boxprobe
