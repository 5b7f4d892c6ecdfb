// The kinds of values that differ between two scenes, from the kinds in the rows of the fields that differ.
#include <unordered_map>

#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

namespace {

template <typename Part>
void compare(Changes& changes, const std::vector<FieldRow<Part>>& rows, const Part& before, const Part& after) {
  for (const FieldRow<Part>& row : rows) {
    if (row.changes.empty() || row.equal == nullptr || row.equal(before, after)) continue;
    for (bool Changes::*kind : row.changes) changes.*kind = true;
  }
}

void compareProbes(Changes& changes, const std::vector<Probe>& before, const std::vector<Probe>& after) {
  bool sameList = before.size() == after.size();
  for (std::size_t i = 0; sameList && i < before.size(); ++i) sameList = before[i].name == after[i].name;
  if (sameList) {
    for (std::size_t i = 0; i < before.size(); ++i) compare(changes, probeFields(), before[i], after[i]);
    return;
  }
  changes.probeList = true;
  std::unordered_map<std::string, const Probe*> byName;
  for (const Probe& probe : before) byName.emplace(probe.name, &probe);
  for (const Probe& probe : after) {
    const auto found = byName.find(probe.name);
    if (found != byName.end()) compare(changes, probeFields(), *found->second, probe);
  }
}

}  // namespace

Changes difference(const Scene& before, const Scene& after) {
  Changes changes;
  if (&before == &after) return changes;
  compareProbes(changes, before.probes, after.probes);
  compare(changes, sceneFields(), before, after);
  compare(changes, anySkyFields(), before, after);
  return changes;
}

}  // namespace boxprobe
