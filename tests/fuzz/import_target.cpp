// OBJ, PLY, STL and VTP: what is accepted can be drawn without another look, as with glTF. An OBJ file's MTL follows
// the line "# mtl" in the same input.
#include "filters/core/base/errors.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/fuzz/parse_target.h"
#include "tests/fuzz/scratch_file.h"

namespace boxprobe::fuzz {

namespace {

const ScratchFile& importScratch() {
  static const ScratchFile scratch;
  return scratch;
}

void parseImport(const std::string& name, const std::string& bytes) {
  try {
    const Model model = readModel(importScratch().write(name, bytes));
    promise(!model.instances.empty(), "a model without instances is accepted");
    for (const Mesh& mesh : model.meshes) checkMesh(mesh, model.materials.size());
    for (const std::string& warning : model.warnings) checkRefusal(warning);
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
  }
}

}  // namespace

void parseObjFile(const std::string& bytes) {
  const std::size_t mark = bytes.find("# mtl\n");
  if (mark != std::string::npos) importScratch().write("m.mtl", bytes.substr(mark));
  parseImport("m.obj", bytes.substr(0, mark));
}
void parsePlyFile(const std::string& bytes) {
  parseImport("m.ply", bytes);
}
void parseStlFile(const std::string& bytes) {
  parseImport("m.stl", bytes);
}
void parseVtpFile(const std::string& bytes) {
  parseImport("m.vtp", bytes);
}

}  // namespace boxprobe::fuzz
