#include "app/cli/farm/bake_listing.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/farm/bake_share.h"
#include "app/session/valid_json.h"
#include "filters/core/base/fixed_text.h"
#include "filters/core/scene/bounces.h"
#include "filters/vtk/gl/map_bytes.h"

namespace boxprobe {

std::vector<BakeRow> bakeRows(const OffscreenScene& shown, const std::vector<Probe>& probes, const BakeFolder& folder) {
  std::vector<BakeRow> rows;
  for (const Probe& probe : probes) {
    const std::vector<std::string> keys = shown.renderer().bakeKeys(probe.name);
    BakeRow row{probe.name, keys.empty() ? "" : keys.back(), "missing", 0, probe.bounces, bakeSeconds(probe)};
    for (int bounce = probe.bounces; bounce >= 1 && row.made == 0 && !keys.empty(); --bounce) {
      if (folder.has(keys[static_cast<std::size_t>(bounce - 1)])) row.made = bounce;
    }
    std::error_code none;
    const auto file = std::filesystem::path(folder.path()) / BakeFolder::fileName(probe.name);
    if (row.made == probe.bounces) {
      row.state = "done";
    } else if (std::filesystem::exists(file, none)) {
      row.state = "stale";
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string bakeListText(const std::vector<BakeRow>& rows, const std::vector<Probe>& probes, const std::string& folder,
                         bool lattices) {
  std::string text;
  double seconds = 0.0, bytes = 0.0;
  std::size_t done = 0, memory = 0;
  bool latticed = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BakeRow& row = rows[i];
    text += row.state + std::string(9 - row.state.size(), ' ') + row.name;
    if (row.state != "done" && row.made > 0) {
      text += " (" + std::to_string(row.made) + (allBounces(probes[i]) ? " of at most " : " of ") +
              std::to_string(row.bounces) + " bounces)";
    }
    text += "\n";
    if (row.state == "done") {
      ++done;
    } else {
      seconds += row.seconds;
      bytes += bakeBytes(probes[i]);
    }
    const bool several = row.bounces > 1;
    const bool nodes = lattices && several && probes[i].hasLattice();
    latticed |= nodes;
    const std::size_t lattice = nodes ? latticeBytes(probes[i]) + latticeAtlasBytes(1) : 0;
    memory = std::max(memory, probeMapsBytes(probes[i].faceSize, true) * (several ? 2 : 1) + lattice);
  }
  return text + folder + ": " + std::to_string(done) + " of " + std::to_string(rows.size()) +
         " baked probe(s) done; the rest takes about " + fixedText(seconds, 1) + " s of CPU time and " +
         memoryText(static_cast<std::size_t>(bytes)) + " of files, and a probe " + memoryText(memory) +
         " of texture memory" + (latticed ? ", its lattice included" : "") + "\n";
}

std::string bakeListJson(const std::vector<BakeRow>& rows) {
  std::string text;
  for (const BakeRow& row : rows) {
    text += validJson({{"name", row.name},
                       {"key", row.key},
                       {"state", row.state},
                       {"bounce", row.made},
                       {"bounces", row.bounces},
                       {"seconds", row.seconds}},
                      -1);
  }
  return text;
}

void requireBaked(const std::vector<BakeRow>& rows, int bounce, const std::string& folder) {
  constexpr std::size_t kNamed = 20;
  std::string names;
  std::size_t left = 0;
  for (const BakeRow& row : rows) {
    if (row.made >= (bounce == 0 ? row.bounces : std::min(bounce, row.bounces))) continue;
    if (++left <= kNamed) names += (names.empty() ? "" : ", ") + row.name;
  }
  if (left == 0) return;
  if (left > kNamed) names += " and " + std::to_string(left - kNamed) + " more";
  throw WorkLeft(folder + ": " + std::to_string(left) + " of " + std::to_string(rows.size()) +
                 " baked probe(s) not done: " + names);
}

}  // namespace boxprobe
