#include "filters/io/engines/probe_import.h"

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/base/file_limits.h"
#include "filters/io/engines/probe_text.h"
#include "filters/io/files/read_file.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

ImportedProbes importProbes(const std::string& path) {
  const std::string text = readWholeFile(path, limits::kProbeFileBytes);
  const std::string extension = lowerExtension(path);
  if (extension == ".tscn" || text.rfind("[gd_scene", 0) == 0) return parseGodotProbes(text, path);
  if (text.rfind("%YAML", 0) == 0 || extension == ".unity" || extension == ".prefab") {
    return parseUnityProbes(text, path);
  }
  if (extension == ".json") return parseExportedProbe(text, path);
  throw InputError(path +
                   ": is neither a Unity scene or prefab (text serialization) nor a Godot scene (.tscn), nor a probe's "
                   ".json of boxprobe export");
}

ImportedProbes parseExportedProbe(const std::string& text, const std::string& name) {
  const JsonText json = parseJsonText(text, name);
  const auto found = json.root.find("probe");
  if (!json.root.is_object() || json.root.value("format", Json()) != "boxprobe-export" || found == json.root.end()) {
    throw InputError(name + ": is no probe's .json of boxprobe export; scenes are opened as they are");
  }
  ImportedProbes imported;
  imported.engine = "Boxprobe";
  imported.probes.push_back(probeOfLine(found->dump(), name));
  return imported;
}

}  // namespace boxprobe
