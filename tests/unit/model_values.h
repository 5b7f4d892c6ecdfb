// Reads files of tests/unit/values as models, beside two small pictures.
#pragma once

#include <string>
#include <vector>

#include "filters/io/image/image_file.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/model_lines.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {

class ModelValues : public TemporaryFolder {
 protected:
  /// Two pictures of other sizes, in which no byte stands twice.
  ModelValues() {
    savePng(file("wide.png"), made(3, 2, 5));
    savePng(file("high.png"), made(2, 3, 90));
  }
  static ImageRgba8 made(int width, int height, int seed) {
    ImageRgba8 image{width, height, {}, "made"};
    for (int i = 0; i < 4 * width * height; ++i) {
      image.pixels.push_back(static_cast<std::uint8_t>((seed + 37 * i + 3 * i * i) % 256));
    }
    return image;
  }

  static std::string bytesOf(const std::string& name) {
    std::ifstream stream(BOXPROBE_SOURCE_DIR "/tests/unit/values/" + name, std::ios::binary);
    EXPECT_TRUE(stream) << name;
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::vector<std::string> linesOf(const std::string& name, const std::string& bytes,
                                   const ModelState& state = {}) const {
    const std::string path = write(name, bytes);
    return linesOrError([&] { return readModel(path, {}, state); }, folder_.string());
  }
};

}  // namespace boxprobe
