// Probes out of what engines write as text: Unity's scenes and prefabs (YAML), Godot's scenes (.tscn). Where they are,
// their boxes, blending and switches; pictures stay behind. Called by `boxprobe import`.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct ImportedProbes {
  std::string engine;  ///< "Unity", "Godot"
  std::vector<Probe> probes;
  std::vector<std::string> remarks;  ///< what has no equal here, one sentence each
};

/// Right-handed, +Y up, metres: Unity's x is negated, as importers of glTF for Unity do; Godot's axes are ours. Throws
/// InputError naming the file and, where there is one, the line.
ImportedProbes importProbes(const std::string& path);

/// The same from text; `name` stands for the file in messages.
ImportedProbes parseUnityProbes(const std::string& text, const std::string& name);
ImportedProbes parseGodotProbes(const std::string& text, const std::string& name);

}  // namespace boxprobe
