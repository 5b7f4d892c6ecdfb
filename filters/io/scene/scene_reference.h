// The reference of the scene file: every key with its value, range, default, cost and meaning, from the field tables.
// Printed by `boxprobe info --fields`; data/scenes/README.md contains it.
#pragma once

#include <string>

namespace boxprobe {

/// Markdown: one table per part.
std::string sceneReferenceMarkdown();
/// JSON: a list of parts, each with a list of fields. Ends with a newline.
std::string sceneReferenceJson();

}  // namespace boxprobe
