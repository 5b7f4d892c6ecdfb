// Chooses the reader for a file, and runs the steps of reading glTF.
#include "filters/io/gltf/model_file.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/files/other_formats.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

// Rough shares of the time: the file's bytes, its pictures, its meshes.
constexpr double kPicturesFrom = 0.1, kMeshesFrom = 0.7;

/// -1 for no variant.
int variantIndex(const GltfFile& file, const std::vector<std::string>& names, const std::string& wanted) {
  if (wanted.empty()) return -1;
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + ("\"" + name + "\"");
  file.fail("variants", "has no variant \"" + wanted + "\"; " + (known.empty() ? "it has none" : "it has " + known));
}

}  // namespace

Model loadModelFile(const std::string& path, const LoadProgress& progress, const ModelState& state) {
  const auto report = [&](double from, double to) {
    return [&progress, &path, from, to](double share) {
      if (progress && !progress(from + (to - from) * share)) throw LoadCancelled(path + ": loading was cancelled");
    };
  };
  const std::string extension = lowerExtension(path);
  if (extension != ".gltf" && extension != ".glb") {
    const std::string advice = conversionAdvice(extension);
    if (!advice.empty()) throw InputError(path + ": " + advice);
    const std::string kind = extension.empty() ? "files without an extension" : extension + " files";
    throw InputError(path + ": " + kind + " are not supported; export the model as glTF (.glb or .gltf)");
  }
  report(0.0, kPicturesFrom)(0.0);
  GltfFile file = openGltf(path);
  Model model;
  model.materials = readMaterials(file, report(kPicturesFrom, kMeshesFrom));
  model.variants = variantNames(file);
  model.animationSeconds = animationSeconds(file);
  const GltfMeshReading reading{file, model.materials, variantIndex(file, model.variants, state.variant)};
  const GltfPose pose = state.seconds ? poseAt(file, *state.seconds) : GltfPose();
  GltfNodes nodes = readNodes(reading, pose, report(kMeshesFrom, 1.0));
  warnOfClipping(file, nodes);
  warnOfShape(file, nodes);
  if (file.gltf.scenes.size() > 1) {
    file.warn("has " + std::to_string(file.gltf.scenes.size()) + " scenes, of which the default one is shown");
  }
  model.meshes = std::move(nodes.meshes);
  model.instances = std::move(nodes.instances);
  model.lights = std::move(nodes.lights);
  model.cameras = std::move(nodes.cameras);
  if (model.instances.empty()) file.warn("has no triangles to show");
  model.warnings = std::move(file.warnings);
  return model;
}

}  // namespace boxprobe
