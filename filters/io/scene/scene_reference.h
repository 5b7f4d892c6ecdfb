// The reference of the scene file: every key with its value, range, default, cost and meaning, from the tables that
// read it. Printed by `boxprobe info --fields`; data/scenes/README.md holds it.
#pragma once

#include <string>

namespace boxprobe {

/// Markdown: a table a part.
std::string sceneReferenceMarkdown();
/// JSON: a list of parts, each with a list of fields. Ends in a newline.
std::string sceneReferenceJson();

}  // namespace boxprobe
