// Which gesture an edit belongs to. Called by every control that previews before it commits. What the undo step is
// called is another matter: a label is translated, and two controls may share one.
#pragma once

#include <string>

namespace boxprobe {

/// Previews with the same token go on with each other, and the commit with it ends them: one undo step. Any other edit
/// commits what was previewed first.
struct EditToken {
  const void* control = nullptr;  ///< what is dragged or typed into; null: no gesture, goes on with nothing
  int part = 0;                   ///< of the control: an axis, a face
  std::string target = {};        ///< what is edited where the control edits one of several: a name, an index

  bool operator==(const EditToken& other) const {
    return control == other.control && part == other.part && target == other.target;
  }
};

}  // namespace boxprobe
