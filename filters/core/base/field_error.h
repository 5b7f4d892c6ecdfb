// Where in a scene something is wrong: thrown by validate() and by the reader of scene files. Values are named by key
// path; line numbers are added by whoever has the text.
#pragma once

#include <string>
#include <vector>

#include "filters/core/base/errors.h"

namespace boxprobe {

/// The place of a value in a scene: {"probes", "room", "box"}. Named entries are given by name, or as "[2]" where the
/// name itself is wrong; array elements are "[0]", too.
using KeyPath = std::vector<std::string>;

/// "probes.room.box", "lights[0].color".
std::string keyPathText(const KeyPath& path);

/// An InputError about one value. what() is "probes.room.box: reason"; both parts are also available separately, so
/// that a reader of files can add the line.
class FieldError : public InputError {
 public:
  FieldError(KeyPath path, const std::string& reason);
  const KeyPath& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  KeyPath path_;
  std::string reason_;
};

}  // namespace boxprobe
