// Writes the models of this folder again: `generate_scenes OUTDIR`. The same bytes on every run; a test holds them
// against the files that are checked in. The scene files (*.boxprobe.json) beside them are written by hand.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/core/errors.h"

namespace {

// Written beside its target and renamed: an interrupted run leaves the old file.
void write(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::ofstream stream(temporary, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw boxprobe::WorkError(temporary.string() + ": cannot be written; is there room, and may you?");
  std::filesystem::rename(temporary, path);
  std::cout << path.string() << " " << bytes.size() << " bytes\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate_scenes OUTDIR    writes the scenes' models there\n";
    return 2;
  }
  try {
    using namespace boxprobe::scenes;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    write(folder / "building.glb", glbBytes(building()));
    write(folder / "furnished.glb", glbBytes(furnished()));
    write(folder / "gallery.glb", glbBytes(gallery()));
    write(folder / "room.glb", glbBytes(room()));
    write(folder / "six-faces.glb", glbBytes(sixFaces()));
    write(folder / "sky.hdr", skyHdr());
  } catch (const std::exception& error) {
    std::cerr << "generate_scenes: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
