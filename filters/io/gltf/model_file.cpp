// Which reader takes which file, and the steps of reading a glTF one.
#include "filters/io/gltf/model_file.h"

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

// Shares of the time, roughly: a file's bytes, its pictures, its meshes.
constexpr double kPicturesFrom = 0.1, kMeshesFrom = 0.7;

}  // namespace

Model loadModelFile(const std::string& path, const LoadProgress& progress) {
  const auto report = [&](double from, double to) {
    return [&progress, &path, from, to](double share) {
      if (progress && !progress(from + (to - from) * share)) throw LoadCancelled(path + ": loading was cancelled");
    };
  };
  const std::string extension = lowerExtension(path);
  if (extension != ".gltf" && extension != ".glb") {
    const std::string kind = extension.empty() ? "files without an extension" : extension + " files";
    throw InputError(path + ": " + kind + " are not supported; export the model as glTF (.glb or .gltf)");
  }
  report(0.0, kPicturesFrom)(0.0);
  GltfFile file = openGltf(path);
  Model model;
  model.materials = readMaterials(file, report(kPicturesFrom, kMeshesFrom));
  GltfMeshes meshes = readMeshes(file, model.materials, report(kMeshesFrom, 1.0));
  GltfNodes nodes = readNodes(file, meshes);
  model.instances = std::move(nodes.instances);
  model.lights = std::move(nodes.lights);
  model.cameras = std::move(nodes.cameras);
  model.meshes = std::move(meshes.meshes);
  if (!file.gltf.animations.empty()) file.warn("has animations, which are not supported and are ignored");
  if (model.instances.empty()) file.warn("has no triangles to show");
  model.warnings = std::move(file.warnings);
  return model;
}

}  // namespace boxprobe
