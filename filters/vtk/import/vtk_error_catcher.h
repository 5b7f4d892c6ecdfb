// Captures VTK's errors while a reader runs: VTK's readers print them and continue. Must not be nested; not
// thread-safe.
#pragma once

#include <string>

namespace boxprobe {

class VtkErrorCatcher {
 public:
  VtkErrorCatcher();
  ~VtkErrorCatcher();
  VtkErrorCatcher(const VtkErrorCatcher&) = delete;
  VtkErrorCatcher& operator=(const VtkErrorCatcher&) = delete;

  /// The first error so far on one line, without VTK's file and address; empty: none.
  std::string error() const;

 private:
  struct Impl;
  Impl* impl_;
};

}  // namespace boxprobe
