// See load_scene.h.
#include "app/cli/load_scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "app/cli/fit_scene.h"
#include "filters/core/errors.h"
#include "filters/io/model_file.h"
#include "filters/io/scene_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

bool endsWith(std::string text, const std::string& end) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

LoadedScene loadBareModel(const std::string& path) {
  LoadedScene loaded;
  loaded.scene = sceneForModel(path);
  loaded.models = loadModels(loaded.scene);
  const Box bounds = modelBounds(*loaded.models.front());
  loaded.scene.probes = {fittedProbe(bounds)};
  loaded.scene.cameras = {fittedCamera(bounds)};
  return loaded;
}

}  // namespace

bool isModelPath(const std::string& path) {
  return endsWith(path, ".glb") || endsWith(path, ".gltf");
}

std::vector<std::shared_ptr<const Model>> loadModels(const Scene& scene) {
  std::map<std::string, std::shared_ptr<const Model>> byFile;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& model : scene.models) {
    std::shared_ptr<const Model>& loaded = byFile[model.file];
    if (!loaded) loaded = std::make_shared<const Model>(loadModelFile(model.file));
    models.push_back(loaded);
  }
  return models;
}

std::vector<std::string> sceneWarnings(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  std::vector<std::string> warnings;
  std::vector<const Model*> plain;
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (const std::string& warning : models[i]->warnings) warnings.push_back(scene.models[i].file + ": " + warning);
    plain.push_back(models[i].get());
  }
  for (const auto& remarks : {featuresNotUsed(scene), unmatchedOverrides(scene, plain)}) {
    warnings.insert(warnings.end(), remarks.begin(), remarks.end());
  }
  return warnings;
}

LoadedScene loadScene(const std::string& path, const std::vector<std::string>& assignments) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw InputError(path + ": no such file");
  if (fs::is_directory(path, ignored)) throw InputError(path + ": this is a folder; name a scene or model file in it");
  LoadedScene loaded;
  if (isModelPath(path)) {
    loaded = loadBareModel(path);
    setSceneFields(loaded.scene, assignments);
  } else if (endsWith(path, ".json")) {
    loaded.scene = loadSceneFile(path);
    loaded.path = path;
    setSceneFields(loaded.scene, assignments);
    loaded.models = loadModels(loaded.scene);
  } else {
    throw InputError(path + ": neither a scene (.boxprobe.json) nor a model (.glb, .gltf)");
  }
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);
  return loaded;
}

}  // namespace boxprobe
