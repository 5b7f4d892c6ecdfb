// From a path on the command line to a scene with its models: a *.boxprobe.json file, or a bare model that gets probe,
// camera and light by what it is. Called by the sub-commands and the window; needs no display.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/fit/fit_model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

struct LoadedScene {
  Scene scene;
  std::vector<std::shared_ptr<const Model>> models;  ///< in the order of scene.models
  std::string path;                                  ///< the scene file, absolute; empty for a bare model: never saved
  std::string fileDigest;                            ///< fileDigest() of it as it was read
  std::vector<std::string> warnings;                 ///< sceneWarnings() of it
  std::optional<ModelFit> fit;                       ///< of a bare model
  bool unsaved = false;                              ///< recovered: not what `path` holds
  bool exposureAutomatic = false;                    ///< the scene's exposure is to follow the first picture
  double loadCpuSeconds = 0.0;                       ///< all threads
};

/// `assignments` are those of --set, in order, then validated together. They are applied before the models are read;
/// of a bare model those of models, objects and materials are, and the rest once probe, camera and light are fitted,
/// as `wishes` leave open. Throws InputError naming file and place.
LoadedScene loadScene(const std::string& path, const std::vector<std::string>& assignments = {},
                      const LoadProgress& progress = {}, FitWishes wishes = {});

/// The picture of the studio that lights models without lights.
std::string studioFile();

/// The models a scene names, in its order. A file named twice is read once. Throws LoadCancelled if `progress` says so.
std::vector<std::shared_ptr<const Model>> loadModels(const Scene& scene, const LoadProgress& progress = {});

/// The picture that a scene has as its sky, for references; null for a sky of another kind. Throws InputError.
std::shared_ptr<const ImageRgbaF> loadSkyImage(const Scene& scene);

/// A scene with the sun of its sky's picture among its lights, if that is drawn as one, and the picture without it.
struct SceneOfDrawnSky {
  Scene scene;
  std::shared_ptr<const ImageRgbaF> skyImage;  ///< null for a sky of another kind
};
/// For references that are lit as captures are. Throws InputError.
SceneOfDrawnSky withDrawnSky(Scene scene);

/// What will not show as the files ask, one sentence each: what the model files hold and the program does not support,
/// features of the scene that are accepted but not used yet, overrides and hides that name nothing in the models.
std::vector<std::string> sceneWarnings(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

/// A fingerprint of what the file holds now; empty if there is none or it cannot be read.
std::string fileDigest(const std::string& path);

/// What a scene is called by its file: the file's name without .boxprobe.json, .json or a model's extension.
std::string sceneName(const std::string& path);

/// True for the extensions of model files, which can be opened without a scene, in any case.
bool isModelPath(const std::string& path);

}  // namespace boxprobe
