// Keeps error messages on one readable line, whatever a name in a file or a library's message contains.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// The beginning and end of a text of more than `most` bytes: messages begin with what is wrong and end with what to
/// do.
inline std::string elided(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  // Not in the middle of a character: continuation bytes are 10xxxxxx in UTF-8.
  const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  std::size_t head = most / 2, tail = text.size() - most / 2;
  while (head > 0 && inside(head)) --head;
  while (tail < text.size() && inside(tail)) ++tail;
  return text.substr(0, head) + " ... " + text.substr(tail);
}

/// Replaces control characters (line ends, escape sequences) by spaces; of very long texts only both ends stay.
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
