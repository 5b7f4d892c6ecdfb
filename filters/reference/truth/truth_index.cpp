#include "filters/reference/truth/truth_index.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "filters/core/base/errors.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFloor = "floor";
constexpr const char* kHowToMake = "make it with tests/truth/make.sh, which needs Blender 4.1 or later";

MaterialOverride floorOf(const json& material) {
  MaterialOverride floor;
  const json& color = material.at("baseColor");
  floor.baseColor = glm::vec3(color.at(0).get<float>(), color.at(1).get<float>(), color.at(2).get<float>());
  const auto take = [&material](const char* key, std::optional<float>& value) {
    if (material.contains(key)) value = material.at(key).get<float>();
  };
  take("metallic", floor.metallic);
  take("roughness", floor.roughness);
  take("ior", floor.ior);
  take("coat", floor.coat);
  return floor;
}

TruthPicture pictureOf(const json& entry) {
  TruthPicture picture;
  picture.file = entry.at("picture").get<std::string>();
  picture.scene = entry.at("scene").get<std::string>();
  picture.camera = entry.at("camera").get<std::string>();
  picture.kind = entry.at("kind").get<std::string>();
  picture.roughness = entry.at("roughness").get<double>();
  picture.whole = entry.value("whole", false);
  picture.floor = floorOf(entry.at("material"));
  if (entry.at("material").contains("coatRoughness")) {
    picture.coatRoughness = entry.at("material").at("coatRoughness").get<float>();
  }
  picture.samples = entry.at("samples").get<int>();
  picture.noise = entry.at("noise").get<double>();
  return picture;
}

}  // namespace

std::string TruthIndex::scenePath(const std::string& scene) const {
  return (fs::path(folder) / "scenes" / (scene + ".boxprobe.json")).string();
}

bool TruthIndex::isBox(const std::string& scene) const {
  return std::find(boxScenes.begin(), boxScenes.end(), scene) != boxScenes.end();
}

TruthIndex loadTruthIndex(const std::string& path) {
  if (!fs::exists(path)) throw InputError(path + ": there is no such file; " + kHowToMake);
  const std::string text = readWholeFile(path);
  TruthIndex index;
  index.folder = fs::path(path).parent_path().string();
  try {
    const json root = json::parse(text);
    if (root.at("format") != "boxprobe-truth" || root.at("version") != 1) {
      throw InputError(path + ": not a truth file of this version; " + kHowToMake);
    }
    index.renderer = root.at("renderer").get<std::string>();
    index.width = root.at("width").get<int>();
    index.height = root.at("height").get<int>();
    index.boxScenes = root.at("boxScenes").get<std::vector<std::string>>();
    for (const json& entry : root.at("pictures")) index.pictures.push_back(pictureOf(entry));
  } catch (const json::exception&) {
    throw InputError(path + ": not a truth file; " + kHowToMake);
  }
  if (index.width <= 0 || index.height <= 0 || index.pictures.empty()) {
    throw InputError(path + ": names no pictures; " + kHowToMake);
  }
  return index;
}

ImageRgbaF loadTruthPicture(const TruthIndex& index, const TruthPicture& picture) {
  const std::string path = (fs::path(index.folder) / "pictures" / picture.file).string();
  if (!fs::exists(path)) throw InputError(path + ": there is no such picture; " + kHowToMake);
  ImageRgbaF image = loadHdrImage(path);
  if (image.width != index.width || image.height != index.height) {
    throw InputError(path + ": is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                     ", the truth file says " + std::to_string(index.width) + " x " + std::to_string(index.height) +
                     "; " + kHowToMake);
  }
  return image;
}

Scene withTruthFloor(Scene scene, const TruthPicture& picture) {
  scene.materials[kFloor] = picture.floor;
  return scene;
}

std::vector<std::shared_ptr<const Model>> withTruthFloor(std::vector<std::shared_ptr<const Model>> models,
                                                         const TruthPicture& picture) {
  if (!picture.coatRoughness) return models;  // the same models: no recapture
  for (std::shared_ptr<const Model>& model : models) {
    const auto changed = std::make_shared<Model>(*model);
    for (Material& material : changed->materials) {
      if (material.name == kFloor) material.coatRoughness = *picture.coatRoughness;
    }
    model = changed;
  }
  return models;
}

}  // namespace boxprobe
