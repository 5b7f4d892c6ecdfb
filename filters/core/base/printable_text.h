// Names come from files and end up on terminals and in JSON: makes them harmless for both.
#pragma once

#include <string>

namespace boxprobe {

/// `text` as valid UTF-8 that is safe on a terminal: each control character (C0, C1, DEL, line and paragraph
/// separators) and each override or isolate of writing direction becomes a space, each invalid byte the replacement
/// character U+FFFD. Right-to-left letters stay. `keepLines`: line ends stay.
std::string printable(const std::string& text, bool keepLines = false);

}  // namespace boxprobe
