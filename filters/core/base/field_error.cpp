// Key paths as text; see the header.
#include "filters/core/base/field_error.h"

#include "filters/core/base/one_line.h"

namespace boxprobe {

std::string keyPathText(const KeyPath& path) {
  std::string text;
  for (const std::string& key : path) {
    if (!text.empty() && key.rfind('[', 0) != 0) text += '.';
    text += key;
  }
  return text;
}

FieldError::FieldError(KeyPath path, const std::string& reason)
    : InputError(oneLine(path.empty() ? reason : keyPathText(path) + ": " + reason)),
      path_(std::move(path)),
      reason_(reason) {}

}  // namespace boxprobe
