// What VTK reports while a reader runs, as a value: its readers print their errors and go on. Called by the readers of
// models; not to be nested, and for one thread.
#pragma once

#include <string>

namespace boxprobe {

class VtkErrorCatcher {
 public:
  VtkErrorCatcher();
  ~VtkErrorCatcher();
  VtkErrorCatcher(const VtkErrorCatcher&) = delete;
  VtkErrorCatcher& operator=(const VtkErrorCatcher&) = delete;

  /// The first error so far without VTK's file and address, on one line; empty: none.
  std::string error() const;

 private:
  struct Impl;
  Impl* impl_;
};

}  // namespace boxprobe
