// Which reader takes which file, and the steps of reading a glTF one.
#include "filters/io/model_file.h"

#include <cctype>
#include <filesystem>

#include "filters/core/errors.h"
#include "filters/io/gltf_parts.h"

namespace boxprobe {

Model loadModelFile(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".gltf" && extension != ".glb") {
    const std::string kind = extension.empty() ? "files without an extension" : extension + " files";
    throw InputError(path + ": " + kind + " are not supported; export the model as glTF (.glb or .gltf)");
  }
  GltfFile file = openGltf(path);
  Model model;
  model.materials = readMaterials(file);
  GltfMeshes meshes = readMeshes(file);
  model.instances = readInstances(file, meshes);
  model.meshes = std::move(meshes.meshes);
  if (!file.gltf.animations.empty()) file.warn("has animations, which are not supported and left out");
  if (model.instances.empty()) file.warn("has no triangles to show");
  model.warnings = std::move(file.warnings);
  return model;
}

}  // namespace boxprobe
