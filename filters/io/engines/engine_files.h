// The files that take an export into an engine: data/engines, compiled into the program. Which of them suit a format
// and a ladder, and what is filled in for a probe. Knows no folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filters/io/engines/probe_json.h"

namespace boxprobe {

struct EngineRow {
  std::string_view engine;   ///< "three.js"
  std::string_view file;     ///< of data/engines
  std::string_view formats;  ///< space separated
  std::string_view ladders;  ///< that it can read
  bool centered = false;     ///< its lookups start in the middle of the box (--center)
  bool perProbe = false;     ///< one for each probe, named after it; fields between two at signs are filled in
};

const std::vector<EngineRow>& engineRows();

struct EngineFile {
  std::string name;  ///< beside the picture
  std::string text;
};

/// Those for this format and ladder, in the order of the rows; of rows for each probe, one for each of `probes`.
std::vector<EngineFile> engineFiles(const std::vector<ExportedProbe>& probes, std::string_view format,
                                    std::string_view ladder);

}  // namespace boxprobe
