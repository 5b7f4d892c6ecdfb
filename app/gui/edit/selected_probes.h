// What the selected probes have in common, for forms that show several at once. Called by the panels.
#pragma once

#include <algorithm>
#include <vector>

#include "app/gui/edit/editor.h"

namespace boxprobe {

class SelectedProbes {
 public:
  /// As they are now; valid until the next change of the document.
  explicit SelectedProbes(const Editor& editor) {
    for (const std::size_t index : editor.selected()) probes_.push_back(&editor.scene().probes[index]);
  }
  std::size_t count() const { return probes_.size(); }
  /// Whether not all have the same `get(probe)`.
  template <typename Get>
  bool differ(const Get& get) const {
    return std::any_of(probes_.begin(), probes_.end(),
                       [&](const Probe* probe) { return !(get(*probe) == get(*probes_.front())); });
  }

 private:
  std::vector<const Probe*> probes_;
};

}  // namespace boxprobe
