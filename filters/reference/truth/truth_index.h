// The truth pictures: what an independent path tracer (Cycles) made of the scenes of tests/truth, and under which
// settings. Called by whatever is held against them; knows no renderer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// One picture of a floor: linear, black with alpha 0 where something else is seen.
struct TruthPicture {
  std::string file;  ///< in the folder `pictures`
  std::string scene, camera;
  std::string kind;  ///< of the floor: "metal", "dielectric", "coat"
  double roughness = 0.0;
  bool whole = false;  ///< the whole scene as the camera sees it, to compare directions; not for judging
  MaterialOverride floor;
  std::optional<float> coatRoughness;  ///< of the floor: a scene cannot override that, a model has it
  int samples = 0;
  double noise = 0.0;  ///< relative RMS of the picture's own noise, by two seeds
};

struct TruthIndex {
  std::string folder;    ///< of the file
  std::string renderer;  ///< which made them
  int width = 0, height = 0;
  std::vector<std::string> boxScenes;  ///< those that are exactly their probe's box
  std::vector<TruthPicture> pictures;

  std::string scenePath(const std::string& scene) const;  ///< of the scene file
  bool isBox(const std::string& scene) const;
};

/// Throws InputError, one line that says how to make it, for a file that is not there or is none.
TruthIndex loadTruthIndex(const std::string& path);

/// Throws InputError for a picture that is not there or has another size than the index says.
ImageRgbaF loadTruthPicture(const TruthIndex& index, const TruthPicture& picture);

/// The scene, and its models, with the picture's material on the floor.
Scene withTruthFloor(Scene scene, const TruthPicture& picture);
std::vector<std::shared_ptr<const Model>> withTruthFloor(std::vector<std::shared_ptr<const Model>> models,
                                                         const TruthPicture& picture);

}  // namespace boxprobe
