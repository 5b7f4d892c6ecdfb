// Images of a glTF file, decoded: several at a time, and none that is in memory already.
#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/image/image_pool.h"

namespace boxprobe {

std::map<int, std::shared_ptr<const ImageRgba8>> decodeImages(const GltfFile& file, const std::set<int>& images,
                                                              const std::function<void(double)>& progress) {
  std::vector<EncodedImage> encoded;
  for (const int index : images) {
    const tinygltf::Image& source = file.gltf.images[static_cast<std::size_t>(index)];
    const std::string called = source.uri.empty() ? source.name : source.uri;
    const std::string place = "image " + std::to_string(index);
    EncodedImage image;
    image.place = oneLine(file.path + ": " + place + (called.empty() ? "" : " (" + called + ")"));
    image.name = called.empty() ? place : called;
    if (source.bufferView >= 0) {
      const ByteRange bytes = bufferViewBytes(file, source.bufferView, place);
      image.data = bytes.data;
      image.size = bytes.size;
    } else if (const auto kept = file.encodedImages.find(index); kept != file.encodedImages.end()) {
      image.data = reinterpret_cast<const unsigned char*>(kept->second.data());
      image.size = kept->second.size();
    }
    encoded.push_back(std::move(image));
  }
  const auto decoded = imagePool().decode(encoded, progress);
  std::map<int, std::shared_ptr<const ImageRgba8>> result;
  auto image = decoded.begin();
  for (const int index : images) result[index] = *image++;
  return result;
}

}  // namespace boxprobe
