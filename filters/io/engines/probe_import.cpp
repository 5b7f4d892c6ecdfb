#include "filters/io/engines/probe_import.h"

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

ImportedProbes importProbes(const std::string& path) {
  constexpr std::uintmax_t kMost = std::uintmax_t(256) << 20;
  const std::string text = readWholeFile(path, kMost);
  const std::string extension = lowerExtension(path);
  if (extension == ".tscn" || text.rfind("[gd_scene", 0) == 0) return parseGodotProbes(text, path);
  if (text.rfind("%YAML", 0) == 0 || extension == ".unity" || extension == ".prefab") {
    return parseUnityProbes(text, path);
  }
  throw InputError(path + ": is neither a Unity scene or prefab (text serialization) nor a Godot scene (.tscn)");
}

}  // namespace boxprobe
