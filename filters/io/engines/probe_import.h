// Reads probes from the text files of engines: Unity's scenes and prefabs (YAML), Godot's scenes (.tscn), and the JSON
// files of our own exports. Imports placement, boxes, blending and switches, but no pictures.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct ImportedProbes {
  std::string engine;  ///< "Unity", "Godot", "Boxprobe"
  std::vector<Probe> probes;
  std::vector<std::string> remarks;  ///< features without an equivalent, one sentence each
};

/// Right-handed, +Y up, metres: Unity's x is negated, as Unity's glTF importers do; Godot's axes are the same as ours.
/// Throws InputError with the file and, if known, the line.
ImportedProbes importProbes(const std::string& path);

/// The same from text; `name` stands for the file in messages.
ImportedProbes parseUnityProbes(const std::string& text, const std::string& name);
ImportedProbes parseGodotProbes(const std::string& text, const std::string& name);
/// The JSON file beside an exported probe's picture.
ImportedProbes parseExportedProbe(const std::string& text, const std::string& name);

}  // namespace boxprobe
