// Errors are one line that people read, whatever a name in a file or a library's message holds.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// The beginning and the end of a text of more than `most` bytes: what is wrong stands in front, what to do at the end.
inline std::string elided(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  // Not in the middle of a character: its further bytes are 10xxxxxx in UTF-8.
  const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  std::size_t head = most / 2, tail = text.size() - most / 2;
  while (head > 0 && inside(head)) --head;
  while (tail < text.size() && inside(tail)) ++tail;
  return text.substr(0, head) + " ... " + text.substr(tail);
}

/// Control characters (line ends, escape sequences for terminals) as spaces; of pages on end the first and last lines.
inline std::string oneLine(const std::string& text) {
  constexpr std::size_t kMost = 1000;
  std::string line = elided(text, kMost);
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace boxprobe
