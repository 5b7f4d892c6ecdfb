// The files that load an export in an engine: data/engines, compiled into the program. Selects those for a format and
// ladder, and fills in values of a probe.
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
  std::string_view ladders;  ///< ladders that it can read
  bool centered = false;     ///< its lookups start in the middle of the box (--center)
  bool perProbe = false;     ///< one file per probe, named after it; placeholders between at signs are filled in
};

const std::vector<EngineRow>& engineRows();

struct EngineFile {
  std::string name;  ///< name in the folder of the picture
  std::string text;
};

/// The files for this format and ladder, in the order of the rows; per-probe rows give one file for each of `probes`.
std::vector<EngineFile> engineFiles(const std::vector<ExportedProbe>& probes, std::string_view format,
                                    std::string_view ladder);

}  // namespace boxprobe
