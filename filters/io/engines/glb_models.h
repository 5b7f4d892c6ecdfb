// Models of any format, and several of them, as one glTF document. Internal to this folder, and for what exports
// scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/gltf/glb_document.h"

namespace boxprobe {

using SceneModels = std::vector<std::shared_ptr<const Model>>;

/// Several models, or one that is no .glb or .gltf? The file of any other is taken as it is.
bool needsJoining(const Scene& scene);

/// What this program draws of the scene's models, without its overrides: meshes, materials and pictures (as PNG), each
/// instance placed in the world as scene.models say, in metres with +Y up. Nodes keep their names. Read again, it draws
/// the same, to the bit but for turned texture coordinates and sheared instances, whose last digits may differ.
/// Lights, cameras, animations and variants are left out: of the latter two it is what the scene shows.
GlbDocument documentOfModels(const Scene& scene, const SceneModels& models);

/// Writes that document into `folder`, and returns the scene with it in the place of its models. Throws InputError for
/// more than a .glb holds, WorkError.
Scene withJoinedModels(const Scene& scene, const SceneModels& models, const std::string& folder);

}  // namespace boxprobe
