// Text inside HTML, between tags and in quoted attributes. Called by whatever writes pages without Qt.
#pragma once

#include <string>

#include "filters/core/base/printable_text.h"

namespace boxprobe {

/// Names come from files: control characters and bytes that are no UTF-8 go, too.
inline std::string markup(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace boxprobe
