// Decodes images of a glTF file in parallel; images already in memory are reused.
#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/image/image_pool.h"

namespace boxprobe {

bool readImage(GltfFile& file, int index, const std::string& where) {
  if (index < 0 || static_cast<std::size_t>(index) >= file.images.size()) {
    file.fail(where,
              "image " + std::to_string(index) + " does not exist; the file has " + std::to_string(file.images.size()));
  }
  GltfImage& image = file.images[static_cast<std::size_t>(index)];
  if (image.uri.empty() || !image.bytes.empty()) return true;
  const std::unique_ptr<std::string> bytes = readUri(file, image.uri);
  if (!bytes) {
    file.warn(oneLine("has the texture " + image.uri.substr(0, 200) + ", which does not exist; grey takes its place"));
    return false;
  }
  image.bytes = std::move(*bytes);
  if (isDataUri(image.uri)) image.uri = "data:";  // the rest is no longer needed
  return true;
}

std::map<int, std::shared_ptr<const ImageRgba8>> decodeImages(GltfFile& file, const std::set<int>& images,
                                                              const std::function<void(double)>& progress) {
  std::vector<EncodedImage> encoded;
  for (const int index : images) {
    const GltfImage& source = file.images[static_cast<std::size_t>(index)];
    const bool named = !source.uri.empty() && source.uri != "data:";
    const std::string called = named ? source.uri : source.name;
    const std::string place = "image " + std::to_string(index);
    EncodedImage image;
    image.place = oneLine(file.path + ": " + place + (called.empty() ? "" : " (" + called + ")"));
    image.name = called.empty() ? place : called;
    if (source.uri.empty()) {
      const ByteRange bytes = bufferViewBytes(file, source.bufferView, place);
      image.data = bytes.data;
      image.size = bytes.size;
    } else {
      image.data = reinterpret_cast<const unsigned char*>(source.bytes.data());
      image.size = source.bytes.size();
    }
    encoded.push_back(std::move(image));
  }
  std::vector<std::string> problems;
  const auto decoded = imagePool().decode(encoded, progress, problems);
  for (const std::string& problem : problems) {
    if (problem.empty()) continue;
    const std::string own = file.path + ": ";  // those who show warnings name the file
    const std::string text = problem.compare(0, own.size(), own) == 0 ? problem.substr(own.size()) : problem;
    file.warn(oneLine(text + "; grey takes its place, or it is left out"));
  }
  std::map<int, std::shared_ptr<const ImageRgba8>> result;
  auto image = decoded.begin();
  for (const int index : images) result[index] = *image++;
  return result;
}

}  // namespace boxprobe
