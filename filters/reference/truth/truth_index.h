// Pictures that an independent path tracer (Cycles) rendered of the scenes of tests/truth, with their settings.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// One picture of a floor: linear, black with alpha 0 elsewhere.
struct TruthPicture {
  std::string file;  ///< in the folder `pictures`
  std::string scene, camera;
  std::string kind;  ///< of the floor: "metal", "dielectric", "coat"
  double roughness = 0.0;
  bool whole = false;  ///< the whole scene, to compare directions; not for measuring
  MaterialOverride floor;
  std::optional<float> coatRoughness;  ///< of the floor: part of the model, because scenes cannot override it
  int samples = 0;
  double noise = 0.0;  ///< relative RMS of the picture's own noise, from two seeds
};

struct TruthIndex {
  std::string folder;    ///< of the file
  std::string renderer;  ///< that made the pictures
  int width = 0, height = 0;
  std::vector<std::string> boxScenes;  ///< scenes that are exactly their probe's box
  std::vector<TruthPicture> pictures;

  std::string scenePath(const std::string& scene) const;  ///< of the scene file
  bool isBox(const std::string& scene) const;
};

/// Throws InputError, with the command that makes the file, if it is missing or invalid.
TruthIndex loadTruthIndex(const std::string& path);

/// Throws InputError for a picture that is missing or has another size than in the index.
ImageRgbaF loadTruthPicture(const TruthIndex& index, const TruthPicture& picture);

/// The scene, and below its models, with the picture's material on the floor.
Scene withTruthFloor(Scene scene, const TruthPicture& picture);
std::vector<std::shared_ptr<const Model>> withTruthFloor(std::vector<std::shared_ptr<const Model>> models,
                                                         const TruthPicture& picture);

}  // namespace boxprobe
