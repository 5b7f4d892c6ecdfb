// Reads and writes OpenEXR pictures. Written as float RGBA, ZIP, scan lines; read through exr_reader.h.
#include <OpenEXR/ImfChannelList.h>

#include "filters/io/image/exr_reader.h"
#include "filters/io/image/exr_writer.h"
#include "filters/io/image/image_detail.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

ImageRgbaF loadExr(const std::string& path) {
  ImageRgbaF image;
  withExrFile(path, [&](Imf::MultiPartInputFile& file) {
    ExrPicture picture = readExrPart(file, picturePart(file, path), path);
    convertToRec709(picture);
    image = std::move(picture.image);
  });
  return image;
}

void saveExr(const std::string& path, const ImageRgbaF& image, const std::vector<ExtraChannel>& extra) {
  checkPixelCount(path, image.width, image.height, image.pixels.size());
  ExrPart part = exrPart(image.width, image.height);
  addRgba(part.levels.front(), image.pixels.data(), ExrPrecision::Float);
  for (const ExtraChannel& channel : extra) {
    checkPixelCount(path, image.width, image.height, 4 * channel.values.size());
    addPlane(part.levels.front(), channel.name, channel.values.data(), 1, ExrPrecision::Float);
  }
  part.header.compression() = Imf::ZIP_COMPRESSION;
  saveExrParts(path, {std::move(part)});
}

}  // namespace boxprobe
