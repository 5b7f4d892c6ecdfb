// How wrong the techniques are that `auto` chooses from, measured with a probe's own final picture in its own box: once
// after a bake and after a drag, never during one. Asked between frames; captures nothing.
#pragma once

#include <memory>
#include <optional>

#include "filters/vtk/probes/shown_probes.h"

namespace boxprobe {

class ProbeErrors {
 public:
  /// Both pointers must outlive this.
  ProbeErrors(const ProbeEntries* entries, ShownProbes* shown, std::shared_ptr<DrawState> state)
      : entries_(entries), shown_(shown), state_(std::move(state)) {}

  /// The first probe whose errors are those of another picture or box.
  std::optional<std::size_t> next() const;
  /// What objects are drawn with may change by it; the caller assigns.
  void measure(std::size_t index);

 private:
  bool stale(std::size_t index) const;

  const ProbeEntries* entries_;
  ShownProbes* shown_;
  std::shared_ptr<DrawState> state_;
};

}  // namespace boxprobe
