// What the program says to its user: messages on stderr, one line each, always; results on stdout. Whatever names hold,
// terminals show it and do not obey it. Called by main, the sub-commands and the window.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// `text` as printable() has it, on one line and with single spaces: file names and library messages may hold anything.
std::string singleLine(const std::string& text);

/// `boxprobe: TEXT`
void printError(const std::string& text);

/// The text alone: something the program decided by itself.
void printNote(const std::string& text);

/// `boxprobe: warning: TEXT` for each, in order; a text that was printed before is left out.
void printWarnings(const std::vector<std::string>& texts);

/// Lines of text to stdout, each as printable() has it.
void printResult(const std::string& text);

/// A document to stdout as it is: valid JSON or a script, whose strings are other programs' business.
void printDocument(const std::string& text);

/// To be called once all is printed: throws WorkError if stdout did not take all of it (a full disk, a closed pipe).
void finishResults();

}  // namespace boxprobe
