#include "filters/vtk/surface/anchor_edits.h"

#include "filters/vtk/surface/text_replace.h"

namespace boxprobe {

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

void AnchorEdits::replace(std::string& text, const std::string& what, const std::vector<Wording>& wordings,
                          int wanted) {
  if (!failure_.empty()) return;
  int found = 0;
  for (const Wording& wording : wordings) found += countOf(text, wording.from);
  counts_.push_back({what, found});
  if (found != wanted) {
    fail(what, wordings.front().from, found, wanted);
    return;
  }
  for (const Wording& wording : wordings) replaceAll(text, wording.from, wording.to);
}

int AnchorEdits::replaceAny(std::string& text, const std::string& what, const std::vector<Wording>& wordings) {
  if (!failure_.empty()) return 0;
  int found = 0;
  for (const Wording& wording : wordings) {
    found += countOf(text, wording.from);
    replaceAll(text, wording.from, wording.to);
  }
  counts_.push_back({what, found});
  return found;
}

void AnchorEdits::insertAtMain(std::string& text, const std::string& what, const std::string& declarations,
                               const std::string& first) {
  constexpr const char* kMain = "void main()\n{";
  replace(text, what, {{kMain, declarations + kMain + first}});
}

void AnchorEdits::fail(const std::string& what, const std::string& sought, int found, int wanted) {
  std::string line = sought;
  for (char& c : line) c = c == '\n' ? ' ' : c;
  failure_ =
      what + " (" + std::to_string(found) + " places in place of " + std::to_string(wanted) + "): \"" + line + "\"";
}

}  // namespace boxprobe
