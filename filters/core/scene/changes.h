// The kinds of difference between two scenes, by what it takes to show them. A field's row names its kinds
// (scene_field.h); the document passes them to its views.
#pragma once

#include <string_view>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// The kinds of values that differ between two scenes, from which a view derives what to update.
struct Changes {
  bool probeShape = false;      ///< new uniforms
  bool probeTechnique = false;  ///< perhaps another shader program
  bool probeCapture = false;    ///< a new capture, or new filtering
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

/// One kind of change. `cost`: what showing it takes, in one line; "" for kinds that no field of a scene has.
struct ChangeRow {
  bool Changes::*member;
  std::string_view id;
  std::string_view cost;
};
/// One row per member of Changes.
const std::vector<ChangeRow>& changeRows();

/// Compares the two scenes field by field.
Changes difference(const Scene& before, const Scene& after);

}  // namespace boxprobe
