// See load_scene.h.
#include "app/session/load_scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "app/session/fit_scene.h"
#include "filters/core/base/errors.h"
#include "filters/core/geometry/mirror_plane.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/import/model_reader.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

bool endsWith(std::string text, const std::string& end) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A scene without lights or cameras of its own has those of its models, which saving then writes down.
void adoptFromModels(LoadedScene& loaded) {
  Scene& scene = loaded.scene;
  const bool lights = scene.lights.empty(), cameras = scene.cameras.empty();
  for (std::size_t i = 0; i < loaded.models.size(); ++i) {
    if (lights) {
      for (const Light& light : placedLights(*loaded.models[i], scene.models[i])) scene.lights.push_back(light);
    }
    if (!cameras) continue;
    for (Camera camera : placedCameras(*loaded.models[i], scene.models[i])) {
      const std::string stem = camera.name;
      const auto taken = [&] {
        return std::any_of(scene.cameras.begin(), scene.cameras.end(),
                           [&](const Camera& other) { return other.name == camera.name; });
      };
      for (int copy = 2; taken(); ++copy) camera.name = stem + " " + std::to_string(copy);
      scene.cameras.push_back(camera);
    }
  }
  try {
    validate(scene);
  } catch (const InputError& error) {
    throw InputError(scene.models.front().file + ": " + error.what());
  }
}

/// What validate() cannot see without the models.
void requireMirrors(const LoadedScene& loaded, const std::string& path) {
  try {
    checkMirrors(loaded.scene, loaded.models);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// What says how the model is read, and so comes before that.
std::vector<std::string> modelAssignments(const std::vector<std::string>& assignments) {
  std::vector<std::string> list;
  for (const std::string& assignment : assignments) {
    if (assignment.rfind("models.", 0) == 0) list.push_back(assignment);
  }
  return list;
}

LoadedScene loadBareModel(const std::string& path, const std::vector<std::string>& assignments,
                          const LoadProgress& progress) {
  LoadedScene loaded;
  loaded.scene = sceneForModel(path);
  setSceneFields(loaded.scene, modelAssignments(assignments));
  loaded.models = loadModels(loaded.scene, progress);
  const Box bounds = modelBounds(*loaded.models.front());
  loaded.scene.probes = {fittedProbe(bounds)};
  loaded.scene.cameras.clear();
  adoptFromModels(loaded);
  if (loaded.scene.cameras.empty()) loaded.scene.cameras = {fittedCamera(bounds)};
  return loaded;
}

}  // namespace

bool isModelPath(const std::string& path) {
  return isModelFile(path);
}

std::vector<std::shared_ptr<const Model>> loadModels(const Scene& scene, const LoadProgress& progress) {
  std::map<std::tuple<std::string, std::string, std::optional<double>>, std::shared_ptr<const Model>> byFile;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& model : scene.models) {
    std::shared_ptr<const Model>& loaded = byFile[{model.file, model.variant, model.time}];
    const double before = static_cast<double>(models.size()), all = static_cast<double>(scene.models.size());
    const LoadProgress share = [&](double done) { return !progress || progress((before + done) / all); };
    if (!loaded) loaded = std::make_shared<const Model>(readModel(model.file, share, {model.variant, model.time}));
    models.push_back(loaded);
  }
  return models;
}

std::shared_ptr<const ImageRgbaF> loadSkyImage(const Scene& scene) {
  const auto* image = std::get_if<SkyImage>(&scene.sky);
  return image != nullptr ? std::make_shared<ImageRgbaF>(loadSkyPicture(image->file)) : nullptr;
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

LoadedScene loadScene(const std::string& path, const std::vector<std::string>& assignments,
                      const LoadProgress& progress) {
  const double begun = processCpuSeconds();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw InputError(path + ": no such file");
  if (fs::is_directory(path, ignored)) throw InputError(path + ": this is a folder; name a scene or model file in it");
  LoadedScene loaded;
  if (isModelPath(path)) {
    loaded = loadBareModel(path, assignments, progress);
    setSceneFields(loaded.scene, assignments);
    requireMirrors(loaded, path);
  } else if (endsWith(path, ".json")) {
    loaded.scene = loadSceneFile(path);
    loaded.path = path;
    setSceneFields(loaded.scene, assignments);
    loaded.models = loadModels(loaded.scene, progress);
    adoptFromModels(loaded);
    requireMirrors(loaded, path);
  } else {
    throw InputError(path + ": neither a scene (.boxprobe.json) nor a model (" + modelFilePatterns() + ")");
  }
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);
  loaded.loadCpuSeconds = processCpuSeconds() - begun;
  return loaded;
}

}  // namespace boxprobe
