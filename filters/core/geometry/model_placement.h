// Where a model file's frame lies in the world, and what of the file goes into a scene as values of its own. Called by
// whatever places a model: the VTK layer, the ray tracer, the loader of scenes.
#pragma once

#include <glm/mat4x4.hpp>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Units and up axis, then scale, then rotation, then translation of a scene's model entry.
glm::dmat4 worldFromFile(const ModelFile& file);

/// Where an instance stands that its model puts at `placed`: turned about its node's own origin and moved as the scene
/// says.
glm::dmat4 movedInstance(const glm::dmat4& placed, const ObjectOverride& object);
/// The same by the node's name.
glm::dmat4 movedInstance(const glm::dmat4& placed, const Scene& scene, const std::string& node);

/// Metres of one unit.
double metresPerUnit(LengthUnit unit);

/// The model's lights and cameras as `file` places them.
std::vector<Light> placedLights(const Model& model, const ModelFile& file);
std::vector<Camera> placedCameras(const Model& model, const ModelFile& file);

}  // namespace boxprobe
