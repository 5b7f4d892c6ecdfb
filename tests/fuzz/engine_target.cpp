// Unity's YAML, Godot's scenes and our own exports, as `boxprobe import` takes them: what is read makes a scene that
// can be written and read again, or is refused.
#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/scene.h"
#include "filters/io/engines/probe_import.h"
#include "filters/io/scene/scene_file.h"
#include "tests/fuzz/parse_target.h"

namespace boxprobe::fuzz {

namespace {

void importAs(ImportedProbes (*parse)(const std::string&, const std::string&), const std::string& bytes) {
  const char* const folder = "scenes";
  Scene scene;
  bool said = false;
  try {
    const ImportedProbes imported = parse(bytes, "input");
    said = !imported.remarks.empty();
    for (const std::string& remark : imported.remarks) promise(remark.find('\n') == std::string::npos, "a long remark");
    scene.probes = imported.probes;
    validate(scene);
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
    return;
  }
  promise(said || !scene.probes.empty(), "an import without a probe says nothing");
  const Scene again = parseScene(sceneText(scene, folder), "written.boxprobe.json", folder);
  promise(again == scene, "what was imported reads as another scene");
}

}  // namespace

void parseEngineText(const std::string& bytes) {
  importAs(&parseUnityProbes, bytes);
  importAs(&parseGodotProbes, bytes);
  importAs(&parseExportedProbe, bytes);
}

}  // namespace boxprobe::fuzz
