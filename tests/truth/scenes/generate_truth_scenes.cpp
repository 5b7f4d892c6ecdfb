// Writes the models and the sky of this folder again: `generate_truth_scenes OUTDIR`. The same bytes on every run;
// truth_scenes_test compares them with the files in the repository. The scene files beside them are written by hand.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "data/scenes/glb_writer.h"
#include "filters/core/base/errors.h"
#include "tests/truth/scenes/truth_scenes.h"

namespace {

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw boxprobe::WorkError(path.string() + ": cannot be written; is there room, and may you?");
  std::cout << path.string() << " " << bytes.size() << " bytes\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate_truth_scenes OUTDIR\n";
    return 2;
  }
  using namespace boxprobe::scenes;
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    write(folder / "empty.glb", glbBytes(truthEmpty()));
    write(folder / "furnished.glb", glbBytes(truthFurnished()));
    write(folder / "arcade.glb", glbBytes(truthArcade()));
    write(folder / "arcade-sky.hdr", truthArcadeSky());
  } catch (const std::exception& error) {
    std::cerr << "generate_truth_scenes: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
