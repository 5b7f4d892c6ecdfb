// Writes the models of this folder again: `generate_scenes OUTDIR`. The same bytes on every run; a test holds them
// against the files that are checked in. The scene files (*.boxprobe.json) beside them are written by hand. With
// `--apartments N` a model and scene file that are too large to be checked in.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/core/base/errors.h"
#include "filters/io/scene/scene_file.h"

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

struct Options {
  std::string folder;
  int rooms = 0;
  unsigned seed = 1;
};

void generate(const Options& options) {
  using namespace boxprobe::scenes;
  const std::filesystem::path folder = options.folder;
  std::filesystem::create_directories(folder);
  if (options.rooms > 0) {
    Apartments made = apartments(options.rooms, options.seed);
    const std::filesystem::path stem = folder / ("apartments-" + std::to_string(options.rooms));
    write(stem.string() + ".glb", glbBytes(made.model));
    made.scene.models = {boxprobe::ModelFile{stem.string() + ".glb"}};
    boxprobe::saveSceneFile(made.scene, stem.string() + ".boxprobe.json");
    return;
  }
  write(folder / "building.glb", glbBytes(building()));
  write(folder / "flat.glb", glbBytes(flat(), kFlatJpegQuality));
  write(folder / "flat-sky.hdr", flatSkyHdr());
  write(folder / "furnished.glb", glbBytes(furnished()));
  write(folder / "gallery.glb", glbBytes(gallery()));
  write(folder / "glass.glb", glbBytes(glassRoom()));
  write(folder / "mirror-hall.glb", glbBytes(mirrorHall()));
  write(folder / "room.glb", glbBytes(room()));
  write(folder / "six-faces.glb", glbBytes(sixFaces()));
  write(folder / "sky.hdr", skyHdr());
  write(folder / "windows.glb", glbBytes(windows()));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Writes the scenes' models again, or apartments of any number", "generate_scenes");
  Options options;
  program.add_option("OUTDIR", options.folder, "Folder to write to")->required();
  program
      .add_option("--apartments", options.rooms, "Only apartments-N.glb and its scene file: N rooms, as many probes")
      ->check(CLI::Range(1, 8000));
  program.add_option("--seed", options.seed, "Of the apartments' colours, floors and furniture")->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  try {
    generate(options);
  } catch (const std::exception& error) {
    std::cerr << "generate_scenes: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
