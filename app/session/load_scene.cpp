// See load_scene.h.
#include "app/session/load_scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "app/session/opened_glb.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/geometry/mirror_plane.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/world_extent.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/absolute_path.h"
#include "filters/io/files/data_folder.h"
#include "filters/io/files/other_formats.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/import/model_reader.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

bool endsWith(std::string text, const std::string& end) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A scene without lights or cameras of its own has those of its models, which saving then writes down. The lights of a
/// bare model are chosen by then.
void adoptFromModels(LoadedScene& loaded) {
  Scene& scene = loaded.scene;
  const bool lights = scene.lights.empty() && !loaded.fit, cameras = scene.cameras.empty();
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

/// The group that an assignment of --set goes to: "models" of "models.0.unit=mm".
std::string groupOf(const std::string& assignment) {
  return assignment.substr(0, assignment.find_first_of(".[="));
}

/// What changes the model itself, and so what it is.
bool changesModel(const std::string& assignment) {
  const std::string group = groupOf(assignment);
  return group == "model" || group == "models" || group == "objects" || group == "materials";
}

LoadedScene loadBareModel(const std::string& path, const std::vector<std::string>& assignments,
                          const LoadProgress& progress, FitWishes wishes) {
  LoadedScene loaded;
  loaded.scene = sceneForModel(path);
  loaded.scene.probes.clear();
  loaded.scene.cameras.clear();
  std::vector<std::string> first, then;
  for (const std::string& assignment : assignments) (changesModel(assignment) ? first : then).push_back(assignment);
  setSceneFields(loaded.scene, first);
  loaded.models = loadModels(loaded.scene, progress);
  checkGeometry(loaded.scene, loaded.models);
  if (wishes.studio.empty()) wishes.studio = studioFile();
  loaded.fit = fitModel(loaded.scene, loaded.models, wishes);
  adoptFromModels(loaded);
  loaded.scene.tone = Tone::Neutral;
  loaded.scene.groundShadow = loaded.scene.ambientOcclusion = loaded.fit->kind == ModelKind::Object;
  setSceneFields(loaded.scene, then);
  const bool exposureSet = std::any_of(then.begin(), then.end(),
                                       [](const std::string& assignment) { return groupOf(assignment) == "exposure"; });
  loaded.exposureAutomatic = !exposureSet && !loaded.fit->lightKnown;
  return loaded;
}

}  // namespace

std::string studioFile() {
  return dataFile("environments/studio.hdr");
}

std::string fileDigest(const std::string& path) {
  try {
    return ContentHash().add(readWholeFile(path)).text();
  } catch (const Error&) {
    return {};
  }
}

bool isModelPath(const std::string& path) {
  return isModelFile(path);
}

std::string sceneName(const std::string& path) {
  const std::filesystem::path file = std::filesystem::path(path).filename();
  const std::string name = file.string(), own = ".boxprobe.json";
  if (name.size() > own.size() && endsWith(name, own)) return name.substr(0, name.size() - own.size());
  return isModelPath(path) || endsWith(name, ".json") ? file.stem().string() : name;
}

std::vector<std::shared_ptr<const Model>> loadModels(const Scene& scene, const LoadProgress& progress) {
  std::map<std::tuple<std::string, std::string, std::optional<double>>, std::shared_ptr<const Model>> byFile;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& model : scene.models) {
    std::shared_ptr<const Model>& loaded = byFile[{model.file, model.variant, model.time}];
    const double before = static_cast<double>(models.size()), all = static_cast<double>(scene.models.size());
    const LoadProgress share = [&](double done) { return !progress || progress((before + done) / all); };
    if (!loaded) {
      loaded = withMemoryFor(model.file, [&] {
        return std::make_shared<const Model>(readModel(model.file, share, {model.variant, model.time}));
      });
    }
    models.push_back(loaded);
  }
  return models;
}

std::shared_ptr<const ImageRgbaF> loadSkyImage(const Scene& scene) {
  const auto* image = std::get_if<SkyImage>(&scene.sky);
  return image != nullptr ? std::make_shared<ImageRgbaF>(loadSkyPicture(*image)) : nullptr;
}

SceneOfDrawnSky withDrawnSky(Scene scene) {
  SceneOfDrawnSky drawn{std::move(scene), nullptr};
  if (const auto* image = std::get_if<SkyImage>(&drawn.scene.sky)) {
    DrawnSky sky = loadDrawnSky(*image);
    if (sky.sun) drawn.scene.lights.push_back(lightOf(*sky.sun, drawn.scene.skyRotationDegrees));
    drawn.skyImage = std::make_shared<ImageRgbaF>(std::move(sky.image));
  }
  return drawn;
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

namespace {

LoadedScene readScene(const std::string& path, const std::vector<std::string>& assignments,
                      const LoadProgress& progress, FitWishes wishes) {
  const double begun = processCpuSeconds();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw InputError(path + ": no such file");
  if (fs::is_directory(path, ignored)) throw InputError(path + ": this is a folder; name a scene or model file in it");
  LoadedScene loaded;
  if (holdsProbes(path)) {
    loaded.scene = openGlbScene(path);
    setSceneFields(loaded.scene, assignments);
    loaded.models = loadModels(loaded.scene, progress);
    checkGeometry(loaded.scene, loaded.models);
    requireMirrors(loaded, path);
  } else if (isModelPath(path)) {
    loaded = loadBareModel(path, assignments, progress, std::move(wishes));
    requireMirrors(loaded, path);
  } else if (endsWith(path, ".json")) {
    loaded.fileDigest = fileDigest(path);  // before it is read: whoever writes it meanwhile is noticed on saving
    loaded.scene = loadSceneFile(path);
    loaded.path = absolutePath(path);
    setSceneFields(loaded.scene, assignments);
    loaded.models = loadModels(loaded.scene, progress);
    checkGeometry(loaded.scene, loaded.models);
    adoptFromModels(loaded);
    requireMirrors(loaded, path);
  } else {
    const std::string advice = conversionAdvice(lowerExtension(path));
    if (!advice.empty()) throw InputError(path + ": " + advice);
    throw InputError(path + ": neither a scene (.boxprobe.json) nor a model (" + modelFilePatterns() + ")");
  }
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);
  if (loaded.fit)
    loaded.warnings.insert(loaded.warnings.end(), loaded.fit->warnings.begin(), loaded.fit->warnings.end());
  loaded.loadCpuSeconds = processCpuSeconds() - begun;
  return loaded;
}

}  // namespace

LoadedScene loadScene(const std::string& path, const std::vector<std::string>& assignments,
                      const LoadProgress& progress, FitWishes wishes) {
  return withMemoryFor(path, [&] { return readScene(path, assignments, progress, std::move(wishes)); });
}

}  // namespace boxprobe
