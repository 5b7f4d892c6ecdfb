// Names come from files and end on terminals and in JSON: text that does neither any harm. Called by whatever prints.
#pragma once

#include <string>

namespace boxprobe {

/// `text` as valid UTF-8 that a terminal shows and does not obey: each control character (C0, C1, DEL, line and
/// paragraph separators) and each override or isolate of writing direction is a space, each byte that is no UTF-8 the
/// replacement character U+FFFD. Letters of right-to-left scripts stay. `keepLines`: line ends stay.
std::string printable(const std::string& text, bool keepLines = false);

}  // namespace boxprobe
