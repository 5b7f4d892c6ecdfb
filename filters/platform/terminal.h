// Standard error: whether somebody looks at it, and keeping others from it.
#pragma once

namespace boxprobe {

constexpr int kStandardError = 2;  ///< its descriptor

/// Does standard error go to a terminal, which takes escape sequences?
bool errorsGoToTerminal();

/// Another descriptor for what standard error is now, while the first one may be silenced: what anybody writes there
/// is then lost.
class KeptErrors {
 public:
  KeptErrors();
  ~KeptErrors();
  KeptErrors(const KeptErrors&) = delete;
  KeptErrors& operator=(const KeptErrors&) = delete;

  /// Negative if there is none; standard error then stays as it is.
  int kept() const { return kept_; }
  void silence();
  void restore();

 private:
  int kept_;
};

}  // namespace boxprobe
