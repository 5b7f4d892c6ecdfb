// Kinds of change: what each costs, and their sums.
#include "filters/core/scene/changes.h"

namespace boxprobe {

const std::vector<ChangeRow>& changeRows() {
  static const std::vector<ChangeRow> rows = {
      {&Changes::probeShape, "shape", "new uniforms; nothing is captured or compiled"},
      {&Changes::probeTechnique, "technique", "perhaps another shader program"},
      {&Changes::probeCapture, "capture", "the probe is captured or filtered again"},
      {&Changes::probeList, "list", "probes that are new are captured; the others stay"},
      {&Changes::materials, "materials", "new uniforms; probes that see the material are captured again"},
      {&Changes::objects, "objects", "probes that see the object are captured again, unless it is `dynamic`"},
      {&Changes::lights, "lights", "probes that see lit surfaces are captured again"},
      {&Changes::sky, "sky", "probes that clear to the sky, or see surfaces it lights, are captured again"},
      {&Changes::models, "models", "models are loaded; probes that see them are captured again"},
      {&Changes::cameras, "cameras", "another view"},
      {&Changes::exposure, "exposure", "another display of the same light"},
      {&Changes::selection, "selection", ""},
      {&Changes::file, "file", ""},
  };
  return rows;
}

bool Changes::any() const {
  for (const ChangeRow& row : changeRows()) {
    if (this->*row.member) return true;
  }
  return false;
}

Changes& Changes::operator|=(const Changes& other) {
  for (const ChangeRow& row : changeRows()) this->*row.member |= other.*row.member;
  return *this;
}

Changes Changes::all() {
  Changes changes;
  for (const ChangeRow& row : changeRows()) changes.*row.member = true;
  return changes;
}

}  // namespace boxprobe
