// Edits of another program's shader text that are never silent: each names the places it stands on, says how many there
// should be, and is counted. Used by the splice (vtk_pbr_splice.h) and what goes before it; knows nothing of VTK's
// text.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// What one edit found in one program.
struct AnchorCount {
  std::string what;
  int found = 0;
};

class AnchorEdits {
 public:
  /// One of the words an anchor may have, and what takes their place.
  struct Wording {
    std::string from, to;
  };

  /// Replaces every place. Where there are not `wanted` of them over all wordings, nothing is replaced, the first
  /// wording is what was sought, and no later edit does anything.
  void replace(std::string& text, const std::string& what, const std::vector<Wording>& wordings, int wanted = 1);
  /// The same, where any number of places will do; returns how many there were.
  int replaceAny(std::string& text, const std::string& what, const std::vector<Wording>& wordings);
  /// For what can be told without an edit.
  void fail(const std::string& what, const std::string& sought, int found, int wanted);

  /// Empty, or `what`, the line sought, how many places there were and should have been.
  const std::string& failure() const { return failure_; }
  /// In the order of the edits.
  const std::vector<AnchorCount>& counts() const { return counts_; }

 private:
  std::string failure_;
  std::vector<AnchorCount> counts_;
};

/// Places of `part` in `text`, none of which overlap.
int countOf(const std::string& text, const std::string& part);

}  // namespace boxprobe
