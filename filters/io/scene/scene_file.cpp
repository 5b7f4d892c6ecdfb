// Reads and writes scene files, adds positions to errors, and finds the files that a scene refers to.
#include "filters/io/scene/scene_file.h"

#include <filesystem>

#include "filters/core/base/file_limits.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

void requireFile(const std::string& file, KeyPath path, const std::string& wanted) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) {
    throw FieldError(std::move(path), file + " does not exist; correct the name or put the " + wanted + " there");
  }
  if (!fs::is_regular_file(status)) throw FieldError(std::move(path), file + " is not a file; name the " + wanted);
}

void requireFiles(const Scene& scene, const Json& root) {
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    KeyPath path = root.contains("model") ? KeyPath{"model"} : KeyPath{"models", "[" + std::to_string(i) + "]", "file"};
    requireFile(scene.models[i].file, std::move(path), "model");
  }
  if (const auto* image = std::get_if<SkyImage>(&scene.sky)) requireFile(image->file, {"sky", "image"}, "picture");
  for (const Probe& probe : scene.probes) {
    if (probe.mode == ProbeMode::Custom) requireFile(probe.image, {"probes", probe.name, "image"}, "picture");
  }
}

Scene parse(const std::string& text, const std::string& name, const std::string& folder, bool filesMustExist) {
  const JsonText json = parseJsonText(text, name);
  try {
    Scene scene = sceneFromJson(json.root, folder);
    validate(scene);
    if (filesMustExist) requireFiles(scene, json.root);
    return scene;
  } catch (const FieldError& error) {
    throw InputError(json.placeText(pointerForPath(json.root, error.path())) + ": " + error.what());
  }
}

/// The folder of a file, never "", for which names would not be resolved.
std::string folderOf(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace

Scene loadSceneFile(const std::string& path) {
  return parse(readWholeFile(path, limits::kSceneBytes), path, folderOf(path), true);
}

Scene parseScene(const std::string& text, const std::string& name, const std::string& folder) {
  return parse(text, name, folder, false);
}

Scene sceneForModel(const std::string& modelPath) {
  Scene scene;
  scene.models.push_back({modelPath, glm::dvec3(0.0), glm::dvec3(0.0), 1.0});
  scene.cameras.emplace_back();
  scene.probes.emplace_back();
  return scene;
}

std::string sceneText(const Scene& scene, const std::string& folder) {
  return formatJson(sceneToJson(scene, folder, JsonForm::Minimal));
}

void saveSceneFile(const Scene& scene, const std::string& path) {
  validate(scene);  // a file that could not be opened again must not replace a good one
  writeTextAtomically(path, sceneText(scene, folderOf(path)));
}

}  // namespace boxprobe
