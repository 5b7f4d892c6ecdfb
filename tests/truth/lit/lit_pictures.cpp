#include "tests/truth/lit/lit_pictures.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "filters/core/base/errors.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

/// Means over blocks, RGB one after the other.
std::vector<double> blockMeans(const ImageRgbaF& picture, int block) {
  const int across = picture.width / block, down = picture.height / block;
  std::vector<double> means(static_cast<std::size_t>(3 * across * down), 0.0);
  for (int y = 0; y < down * block; ++y) {
    for (int x = 0; x < across * block; ++x) {
      const std::size_t to = static_cast<std::size_t>(3 * ((y / block) * across + x / block));
      const std::size_t from = static_cast<std::size_t>(4 * (y * picture.width + x));
      for (std::size_t channel = 0; channel < 3; ++channel) means[to + channel] += picture.pixels[from + channel];
    }
  }
  for (double& mean : means) mean /= block * block;
  return means;
}

}  // namespace

std::string LitIndex::folder() {
  return BOXPROBE_SOURCE_DIR "/tests/truth/lit";
}

std::string LitIndex::scenePath(const std::string& scene) const {
  return folder() + "/scenes/" + scene + ".boxprobe.json";
}

LitIndex loadLitIndex() {
  const nlohmann::json json = nlohmann::json::parse(readWholeFile(LitIndex::folder() + "/lit.json"));
  LitIndex index;
  index.renderer = json.at("renderer").get<std::string>();
  index.width = json.at("width").get<int>();
  index.height = json.at("height").get<int>();
  index.block = json.at("block").get<int>();
  for (const nlohmann::json& entry : json.at("pictures")) {
    LitPicture picture;
    picture.file = entry.at("picture").get<std::string>();
    picture.scene = entry.at("scene").get<std::string>();
    picture.camera = entry.at("camera").get<std::string>();
    if (entry.at("bounces").is_number()) picture.bounces = entry.at("bounces").get<int>();
    picture.samples = entry.at("samples").get<int>();
    picture.noise = entry.at("noise").get<double>();
    index.pictures.push_back(std::move(picture));
  }
  return index;
}

ImageRgbaF loadLitPicture(const LitIndex& index, const LitPicture& picture) {
  const std::string path = LitIndex::folder() + "/pictures/" + picture.file;
  if (!std::filesystem::exists(path))
    throw InputError(path + ": there is no such picture; make it with tests/truth/make.sh lit");
  ImageRgbaF image = loadHdrImage(path);
  if (image.width != index.width || image.height != index.height)
    throw InputError(path + ": has another size than lit.json says");
  return image;
}

LitError litError(const LitIndex& index, const LitPicture& picture, const ImageRgbaF& truth, const ImageRgbaF& first,
                  const ImageRgbaF& second) {
  const std::vector<double> t = blockMeans(truth, index.block), a = blockMeans(first, index.block),
                            b = blockMeans(second, index.block);
  double light = 0.0, lightTruth = 0.0, squares = 0.0, differences = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double mean = 0.5 * (a.at(i) + b.at(i)), half = 0.5 * (a[i] - b[i]);
    light += mean;
    lightTruth += t[i];
    squares += t[i] * t[i];
    differences += (mean - t[i]) * (mean - t[i]);
    noise += half * half;
  }
  const double ofTruth = picture.noise * picture.noise;
  LitError error;
  error.meanLight = light / lightTruth;
  // The channels of a block have the same noise: three times the squares of what is independent.
  error.lightNoise = std::sqrt(3.0 * (noise + ofTruth * squares)) / lightTruth;
  error.noise = std::sqrt(noise / squares);
  error.relativeRmse = std::sqrt(std::max(differences / squares - noise / squares - ofTruth, 0.0));
  return error;
}

}  // namespace boxprobe
