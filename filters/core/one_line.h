// Errors are one line, whatever a name in a file or a library's message holds.
#pragma once

#include <string>

namespace boxprobe {

/// Control characters (line ends, escape sequences for terminals) as spaces.
inline std::string oneLine(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = ' ';
  }
  return text;
}

}  // namespace boxprobe
