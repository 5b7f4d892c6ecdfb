// See messages.h.
#include "app/session/messages.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/core/base/printable_text.h"

namespace boxprobe {

std::string singleLine(const std::string& text) {
  std::string line;
  for (const char c : printable(text)) {
    if (c != ' ' || (!line.empty() && line.back() != ' ')) line += c;
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

void printResult(const std::string& text) {
  printDocument(printable(text, true));
}

void printDocument(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void finishResults() {
  const bool written = std::fflush(stdout) == 0;
  const int reason = errno;
  if (written && std::ferror(stdout) == 0) return;
  throw WorkError("standard output: not all could be written" +
                  (written ? std::string() : std::string(": ") + std::strerror(reason)));
}

}  // namespace boxprobe
