// What the program says to its user on stderr: one line a message, always. Called by main, the sub-commands and the
// window.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// `text` with line breaks and other control characters turned into single spaces: file names and library messages may
/// hold them, and a message is one line.
std::string singleLine(const std::string& text);

/// `boxprobe: TEXT`
void printError(const std::string& text);

/// The text alone: something the program decided by itself.
void printNote(const std::string& text);

/// `boxprobe: warning: TEXT` for each, in order; a text that was printed before is left out.
void printWarnings(const std::vector<std::string>& texts);

}  // namespace boxprobe
