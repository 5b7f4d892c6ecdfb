// Edits of another program's shader text that cannot fail silently: each edit names its anchors, checks their number,
// and is counted.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// Matches of one edit in one program.
struct AnchorCount {
  std::string what;
  int found = 0;
};

class AnchorEdits {
 public:
  /// One form of an anchor, and its replacement.
  struct Wording {
    std::string from, to;
  };

  /// Replaces every match. Unless there are `wanted` matches over all wordings, nothing is replaced, the failure names
  /// the first wording, and later edits do nothing.
  void replace(std::string& text, const std::string& what, const std::vector<Wording>& wordings, int wanted = 1);
  /// The same for any number of matches; returns their number.
  int replaceAny(std::string& text, const std::string& what, const std::vector<Wording>& wordings);
  /// Puts `declarations` before main(), and `first` where its body begins.
  void insertAtMain(std::string& text, const std::string& what, const std::string& declarations,
                    const std::string& first = {});
  /// Reports a failure that was found without an edit.
  void fail(const std::string& what, const std::string& sought, int found, int wanted);

  /// Empty, or `what`, the line sought, and the actual and expected number of matches.
  const std::string& failure() const { return failure_; }
  /// In the order of the edits.
  const std::vector<AnchorCount>& counts() const { return counts_; }

 private:
  std::string failure_;
  std::vector<AnchorCount> counts_;
};

/// Number of non-overlapping occurrences of `part` in `text`.
int countOf(const std::string& text, const std::string& part);

}  // namespace boxprobe
