// What differs between two scenes, by what it costs to show it. A field's row names its kinds (scene_field.h); views
// are told of them by the document. Knows no view.
#pragma once

#include <string_view>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Which kinds of value differ between two scenes: what a view must do follows from the kind.
struct Changes {
  bool probeShape = false;      ///< new uniforms
  bool probeTechnique = false;  ///< perhaps another shader program
  bool probeCapture = false;    ///< a new capture or filtering
  bool probeList = false;       ///< a probe added, removed, renamed or reordered
  bool materials = false;
  bool objects = false;  ///< planar mirrors, too
  bool lights = false;
  bool sky = false;
  bool models = false;
  bool cameras = false;
  bool exposure = false;
  bool selection = false;
  bool file = false;  ///< path or saved state changed, or another scene was opened

  bool any() const;
  Changes& operator|=(const Changes& other);
  static Changes all();
};

/// One kind of change: `cost` says in one line what shows it, "" for kinds that no field of a scene has.
struct ChangeRow {
  bool Changes::*member;
  std::string_view id;
  std::string_view cost;
};
/// One row a member of Changes.
const std::vector<ChangeRow>& changeRows();

/// Derived, never declared: compares the two scenes field by field.
Changes difference(const Scene& before, const Scene& after);

}  // namespace boxprobe
