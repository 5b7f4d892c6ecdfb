#include "filters/io/obj/mtl_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_pool.h"
#include "filters/io/obj/file_beside.h"

namespace boxprobe {

namespace {

/// A name leads to different files beside different MTL files.
std::string fileKey(const MtlMap& map) {
  return map.file + '\n' + map.name;
}

/// A picture's path from the model's folder.
std::string shownName(const std::string& path, const std::string& modelPath) {
  namespace fs = std::filesystem;
  const fs::path name = fs::path(path).lexically_relative(fs::path(modelPath).parent_path());
  return printable(name.empty() ? path : name.string());
}

std::uint8_t byteOf(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

bool hasAlpha(const ImageRgba8& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    if (image.pixels[i] != 255) return true;
  }
  return false;
}

/// The value at a texel of a picture of another size, bilinear.
float valueAt(const ScalarPicture& picture, int x, int y, int width, int height) {
  if (picture.width == width && picture.height == height) {
    return picture.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  const auto place = [](int at, int of, int count, int& first, int& second) {
    const float position =
        std::clamp((static_cast<float>(at) + 0.5f) * static_cast<float>(count) / static_cast<float>(of) - 0.5f, 0.0f,
                   static_cast<float>(count - 1));
    first = static_cast<int>(position);
    second = std::min(first + 1, count - 1);
    return position - static_cast<float>(first);
  };
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  const float u = place(x, width, picture.width, x0, x1), v = place(y, height, picture.height, y0, y1);
  const auto at = [&](int column, int row) {
    return picture.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(column)];
  };
  return (1.0f - v) * ((1.0f - u) * at(x0, y0) + u * at(x1, y0)) + v * ((1.0f - u) * at(x0, y1) + u * at(x1, y1));
}

std::shared_ptr<ImageRgba8> blank(int width, int height, const std::string& name) {
  auto image = std::make_shared<ImageRgba8>();
  image->width = width;
  image->height = height;
  image->name = oneLine(name);
  image->pixels.resize(std::size_t(4) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return image;
}

/// Heights are grey; normal maps are not.
bool isGrey(const ImageRgba8& image) {
  constexpr int kAlmost = 8;  // JPEG
  std::size_t colored = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const int r = image.pixels[i], g = image.pixels[i + 1], b = image.pixels[i + 2];
    if (std::max(std::abs(r - g), std::abs(g - b)) > kAlmost) ++colored;
  }
  return colored * 100 <= image.pixels.size() / 4;
}

/// Central differences of neighbouring texels, repeated at the edges; v upwards. The steepest slope is encoded as one:
/// gentle ones would be lost in eight bits.
std::shared_ptr<const ImageRgba8> normalsOfHeights(const ScalarPicture& heights, const std::string& name,
                                                   float& strength) {
  const int width = heights.width, height = heights.height;
  const auto at = [&](int x, int y) {
    return heights.values[static_cast<std::size_t>((y + height) % height) * static_cast<std::size_t>(width) +
                          static_cast<std::size_t>((x + width) % width)];
  };
  const auto slope = [&](int x, int y) {
    return glm::vec2(0.5f * (at(x + 1, y) - at(x - 1, y)), 0.5f * (at(x, y - 1) - at(x, y + 1)));
  };
  float steepest = 0.0f;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 s = glm::abs(slope(x, y));
      steepest = std::max({steepest, s.x, s.y});
    }
  }
  strength = steepest > 0.0f ? steepest : 1.0f;
  auto image = blank(width, height, name);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 n = glm::normalize(glm::vec3(-slope(x, y) / strength, 1.0f));
      std::uint8_t* texel = image->pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                                        static_cast<std::size_t>(x));
      for (int c = 0; c < 3; ++c) texel[c] = byteOf(0.5 * static_cast<double>(n[c]) + 0.5);
      texel[3] = 255;
    }
  }
  return image;
}

}  // namespace

MtlPictures::MtlPictures(const std::vector<const MtlMaterial*>& materials, const std::string& modelPath,
                         std::vector<std::string>& warnings, const std::function<void(double)>& progress) {
  std::map<std::string, std::size_t> byPath;
  std::map<std::string, std::string> pathOf;
  std::vector<std::string> bytes, names;
  std::set<std::string> told;
  const auto warn = [&](const std::string& text) {
    if (told.insert(text).second) warnings.push_back(oneLine(text));
  };
  for (const MtlMaterial* material : materials) {
    for (const auto& [key, map] : material->maps) {
      if (pathOf.count(fileKey(map)) > 0) continue;
      const FileBeside found = fileBeside(map.file, map.name, modelPath);
      pathOf[fileKey(map)] = found.path;
      const std::string name = "has the texture " + printable(map.name);
      const std::string instead = key == "map_kd" ? "; grey takes its place" : "; it is left out";
      if (found.path.empty()) {
        warn(name + (found.outside ? ", which lies outside the model's folder; put it inside" + instead
                                   : ", which does not exist" + instead));
        continue;
      }
      if (!byPath.emplace(found.path, names.size()).second) continue;
      names.push_back(found.path);
      try {
        bytes.push_back(readWholeFile(found.path));
      } catch (const InputError& error) {
        bytes.emplace_back();
        warn(std::string(error.what()) + instead);
      }
    }
  }
  std::vector<EncodedImage> encoded;
  for (std::size_t i = 0; i < names.size(); ++i) {
    EncodedImage image;
    image.data = reinterpret_cast<const unsigned char*>(bytes[i].data());
    image.size = bytes[i].size();
    image.place = image.name = shownName(names[i], modelPath);
    encoded.push_back(image);
  }
  std::vector<std::string> problems;
  const auto images = imagePool().decode(encoded, progress, problems);
  for (const std::string& problem : problems) {
    if (!problem.empty()) warn(problem + "; grey takes its place, or it is left out");
  }
  for (const auto& [key, path] : pathOf) {
    if (!path.empty()) decoded_[key] = images[byPath.at(path)];
  }
}

const ImageRgba8* MtlPictures::find(const MtlMap& map) const {
  const auto found = decoded_.find(fileKey(map));
  return found == decoded_.end() ? nullptr : found->second.get();
}

std::string MtlPictures::keyOf(const MtlMap& map) const {
  return fileKey(map) + '\n' + numberText(map.base) + ' ' + numberText(map.gain) + ' ' + map.channel;
}

std::shared_ptr<const ImageRgba8> MtlPictures::color(const MtlMap& map) {
  const auto found = decoded_.find(fileKey(map));
  if (found == decoded_.end() || !found->second) return nullptr;
  if (map.base == 0.0 && map.gain == 1.0) return found->second;
  std::shared_ptr<const ImageRgba8>& made = made_["color\n" + keyOf(map)];
  if (!made) {
    auto image = std::make_shared<ImageRgba8>(*found->second);
    for (std::size_t i = 0; i < image->pixels.size(); ++i) {
      if (i % 4 == 3) continue;
      image->pixels[i] = byteOf(map.base + map.gain * static_cast<double>(image->pixels[i]) / 255.0);
    }
    made = image;
  }
  return made;
}

ScalarPicture MtlPictures::scalar(const MtlMap& map, bool mask) const {
  const ImageRgba8* image = find(map);
  ScalarPicture result;
  if (image == nullptr) return result;
  result.width = image->width;
  result.height = image->height;
  const bool alpha = map.channel == 'm' || (map.channel == '\0' && mask && hasAlpha(*image));
  const int channel = alpha ? 3 : map.channel == 'r' ? 0 : map.channel == 'g' ? 1 : map.channel == 'b' ? 2 : -1;
  result.values.reserve(image->pixels.size() / 4);
  for (std::size_t i = 0; i < image->pixels.size(); i += 4) {
    const std::uint8_t* texel = image->pixels.data() + i;
    const double value = channel >= 0 ? texel[channel] : 0.2126 * texel[0] + 0.7152 * texel[1] + 0.0722 * texel[2];
    result.values.push_back(static_cast<float>(std::clamp(map.base + map.gain * value / 255.0, 0.0, 1.0)));
  }
  return result;
}

std::shared_ptr<const ImageRgba8> MtlPictures::packed(const std::string& key, const ScalarPicture& red,
                                                      const ScalarPicture& green, const ScalarPicture& blue) {
  std::shared_ptr<const ImageRgba8>& made = made_["packed\n" + key];
  if (made) return made;
  const ScalarPicture* largest = &red;
  for (const ScalarPicture* picture : {&green, &blue}) {
    if (picture->values.size() > largest->values.size()) largest = picture;
  }
  const int width = largest->width, height = largest->height;
  auto image = blank(width, height, key);
  std::uint8_t* texel = image->pixels.data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, texel += 4) {
      int c = 0;
      for (const ScalarPicture* picture : {&red, &green, &blue}) {
        texel[c++] =
            picture->values.empty() ? 255 : byteOf(static_cast<double>(valueAt(*picture, x, y, width, height)));
      }
      texel[3] = 255;
    }
  }
  made = image;
  return made;
}

std::shared_ptr<const ImageRgba8> MtlPictures::masked(const std::string& key,
                                                      const std::shared_ptr<const ImageRgba8>& color,
                                                      const ScalarPicture& mask) {
  std::shared_ptr<const ImageRgba8>& made = made_["masked\n" + key];
  if (made) return made;
  const bool larger = color && color->pixels.size() / 4 >= mask.values.size();
  const int width = larger ? color->width : mask.width, height = larger ? color->height : mask.height;
  auto image = blank(width, height, key);
  ScalarPicture channels[3];
  for (int c = 0; color && c < 3; ++c) {
    channels[c].width = color->width;
    channels[c].height = color->height;
    channels[c].values.reserve(color->pixels.size() / 4);
    for (std::size_t i = static_cast<std::size_t>(c); i < color->pixels.size(); i += 4) {
      channels[c].values.push_back(static_cast<float>(color->pixels[i]) / 255.0f);
    }
  }
  std::uint8_t* texel = image->pixels.data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, texel += 4) {
      for (int c = 0; c < 3; ++c) {
        texel[c] = color ? byteOf(static_cast<double>(valueAt(channels[c], x, y, width, height))) : 255;
      }
      texel[3] = byteOf(static_cast<double>(valueAt(mask, x, y, width, height)));
    }
  }
  made = image;
  return made;
}

std::shared_ptr<const ImageRgba8> MtlPictures::normals(const MtlMap& map, bool mayBeHeights, float& strength) {
  const std::shared_ptr<const ImageRgba8> image = color(map);
  if (!image || !mayBeHeights || !isGrey(*image)) return image;
  const std::string key = keyOf(map);
  std::shared_ptr<const ImageRgba8>& made = made_["normals\n" + key];
  float& steepest = strengths_[key];
  if (!made) made = normalsOfHeights(scalar(map), key, steepest);
  strength *= steepest;
  return made;
}

}  // namespace boxprobe
