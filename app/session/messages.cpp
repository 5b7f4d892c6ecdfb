// See messages.h.
#include "app/session/messages.h"

#include <cstdio>
#include <set>

namespace boxprobe {

std::string singleLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = static_cast<unsigned char>(c) <= ' ' || c == '\x7f';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

void printError(const std::string& text) {
  std::fprintf(stderr, "boxprobe: %s\n", singleLine(text).c_str());
}

void printNote(const std::string& text) {
  std::fprintf(stderr, "%s\n", singleLine(text).c_str());
}

void printWarnings(const std::vector<std::string>& texts) {
  std::set<std::string> printed;
  for (const std::string& text : texts) {
    const std::string line = singleLine(text);
    if (printed.insert(line).second) std::fprintf(stderr, "boxprobe: warning: %s\n", line.c_str());
  }
}

}  // namespace boxprobe
