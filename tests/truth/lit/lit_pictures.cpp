#include "tests/truth/lit/lit_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

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

/// Numbers of the blocks, the darkest first.
std::vector<std::size_t> byBrightness(const std::vector<double>& means) {
  std::vector<std::size_t> blocks(means.size() / 3);
  std::iota(blocks.begin(), blocks.end(), std::size_t{0});
  const auto light = [&means](std::size_t block) {
    return means[3 * block] + means[3 * block + 1] + means[3 * block + 2];
  };
  std::sort(blocks.begin(), blocks.end(), [&](std::size_t a, std::size_t b) { return light(a) < light(b); });
  return blocks;
}

constexpr double kBlack = 1e-3;  // share of a picture's light that its darker half has at least, or it is black

struct Sums {
  std::size_t blocks = 0;
  double light = 0.0, lightTruth = 0.0, squares = 0.0, differences = 0.0, noise = 0.0;
  void add(double mean, double half, double truth) {
    light += mean;
    lightTruth += truth;
    squares += truth * truth;
    differences += (mean - truth) * (mean - truth);
    noise += half * half;
  }
};

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
  Sums all, dim;
  for (const std::size_t block : byBrightness(t)) {
    if (all.blocks++ == t.size() / 6) dim = all;
    for (std::size_t i = 3 * block; i < 3 * block + 3; ++i) all.add(0.5 * (a[i] + b[i]), 0.5 * (a[i] - b[i]), t[i]);
  }
  const double ofTruth = picture.noise * picture.noise * all.squares;
  LitError error;
  error.meanLight = all.light / all.lightTruth;
  // The channels of a block share their noise: three times the squares of what is independent.
  error.lightNoise = std::sqrt(3.0 * (all.noise + ofTruth)) / all.lightTruth;
  error.noise = std::sqrt(all.noise / all.squares);
  error.relativeRmse = std::sqrt(std::max(all.differences - all.noise - ofTruth, 0.0) / all.squares);
  if (dim.lightTruth > kBlack * all.lightTruth) {
    error.dimLight = dim.light / dim.lightTruth;
    error.dimNoise = std::sqrt(3.0 * (dim.noise + ofTruth)) / dim.lightTruth;
  } else if (dim.light > kBlack * all.lightTruth) {
    error.dimLight = std::numeric_limits<double>::infinity();
  }
  return error;
}

}  // namespace boxprobe
