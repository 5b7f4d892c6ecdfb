// Writes the models and the sky of this folder again: `generate_lit_scenes OUTDIR [LIVING_ROOM.glb]`. The same bytes on
// every run; lit_scenes_test compares them with the files in the repository. The living room is converted from the file
// that Godot's demo projects have, where it is given. The scene files beside them are written by hand.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "data/scenes/glb_writer.h"
#include "filters/core/base/errors.h"
#include "filters/io/gltf/model_file.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

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
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: generate_lit_scenes OUTDIR [LIVING_ROOM.glb]\n";
    return 2;
  }
  using namespace boxprobe::scenes;
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    write(folder / "closed.glb", glbBytes(litClosed()));
    write(folder / "doorway.glb", glbBytes(litDoorway()));
    write(folder / "window.glb", glbBytes(litWindow()));
    write(folder / "furniture.glb", glbBytes(litFurniture()));
    write(folder / "object.glb", glbBytes(litObject()));
    write(folder / "object-sky.hdr", litObjectSky());
    write(folder / "cornell-box.glb", glbBytes(litCornell()));
    if (argc == 3) {
      write(folder / "living-room.glb", glbBytes(litLivingRoom(boxprobe::loadModelFile(argv[2]))));
    }
  } catch (const std::exception& error) {
    std::cerr << "generate_lit_scenes: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
