#include "filters/vtk/import/model_reader.h"

#include <fstream>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/files/read_file.h"
#include "filters/io/obj/obj_file.h"
#include "filters/vtk/import/ply_reader.h"
#include "filters/vtk/import/stl_reader.h"
#include "filters/vtk/import/vtp_reader.h"

namespace boxprobe {

namespace {

/// Git LFS leaves pointers, three lines of text, in place of large files until they are fetched.
void refusePointer(const std::string& path) {
  requireInputFile(path);  // a pipe would be waited for
  constexpr char kFirstLine[] = "version https://git-lfs";
  char start[sizeof(kFirstLine)] = {};
  std::ifstream(path, std::ios::binary).read(start, sizeof(kFirstLine) - 1);
  if (std::string(start) != kFirstLine) return;
  throw InputError(path + ": is a pointer of Git LFS, not the model; fetch it: git lfs pull");
}

}  // namespace

bool isModelFile(const std::string& path) {
  const std::string extension = lowerExtension(path);
  for (const char* known : {".glb", ".gltf", ".obj", ".ply", ".stl", ".vtp"}) {
    if (extension == known) return true;
  }
  return false;
}

const std::string& modelFilePatterns() {
  static const std::string patterns = "*.glb *.gltf *.obj *.ply *.stl *.vtp";
  return patterns;
}

Model readModel(const std::string& path, const LoadProgress& progress, const ModelState& state) {
  refusePointer(path);
  const std::string extension = lowerExtension(path);
  if (!state.variant.empty() && extension != ".glb" && extension != ".gltf") {
    throw InputError(path + ": has no variant \"" + state.variant + "\"; only glTF files have variants");
  }
  if (extension == ".obj") return readObj(path, progress);
  if (extension == ".ply") return readPly(path, progress);
  if (extension == ".stl") return readStl(path, progress);
  if (extension == ".vtp") return readVtp(path, progress);
  return loadModelFile(path, progress, state);
}

}  // namespace boxprobe
