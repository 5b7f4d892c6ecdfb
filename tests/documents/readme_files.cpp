// See readme_files.h.
#include "tests/documents/readme_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>

namespace boxprobe::test {

namespace fs = std::filesystem;

namespace {

bool isFence(const std::string& line) {
  const std::size_t at = line.find_first_not_of(' ');
  return at != std::string::npos && line.compare(at, 3, "```") == 0;
}

bool isBlank(const std::string& line) {
  return line.find_first_not_of(' ') == std::string::npos;
}

bool isIndented(const std::string& line) {
  return line.rfind("    ", 0) == 0 && !isBlank(line);
}

/// The lines that are no code, with their numbers.
std::vector<std::pair<int, std::string>> prose(const Readme& readme) {
  std::vector<std::pair<int, std::string>> lines;
  bool fenced = false;
  for (std::size_t i = 0; i < readme.lines.size(); ++i) {
    const bool fence = isFence(readme.lines[i]);
    // A block leaves an empty line, so that the text before and after it are two paragraphs.
    lines.emplace_back(static_cast<int>(i) + 1, fence || fenced ? "" : readme.lines[i]);
    if (fence) fenced = !fenced;
  }
  return lines;
}

/// The first group of every match.
template <class Add>
void eachMatch(const std::string& line, const std::regex& pattern, Add add) {
  for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it) add((*it)[1].str());
}

}  // namespace

std::vector<Readme> readReadmes(const std::string& root) {
  std::vector<Readme> found;
  for (fs::recursive_directory_iterator it(root), end; it != end; ++it) {
    const std::string name = it->path().filename().string();
    if (it->is_directory() && (name.rfind("build", 0) == 0 || name[0] == '.' || name == "out")) {
      it.disable_recursion_pending();
    } else if (name == "README.md") {
      Readme readme{it->path().lexically_relative(root).string(), {}};
      std::ifstream in(it->path());
      for (std::string line; std::getline(in, line);) readme.lines.push_back(line);
      found.push_back(std::move(readme));
    }
  }
  std::sort(found.begin(), found.end(), [](const Readme& a, const Readme& b) { return a.path < b.path; });
  return found;
}

std::vector<CodeBlock> codeBlocks(const Readme& readme) {
  std::vector<CodeBlock> blocks;
  enum class In { Text, Fence, Indent } in = In::Text;
  bool afterBlank = true;
  for (std::size_t i = 0; i < readme.lines.size(); ++i) {
    const std::string& line = readme.lines[i];
    const int number = static_cast<int>(i) + 1;
    if (in == In::Indent && !isIndented(line)) in = In::Text;
    if (isFence(line)) {
      if (in == In::Text) {
        const std::size_t language = line.find_first_not_of(" `");
        blocks.push_back({{readme.path, number + 1}, language == std::string::npos ? "" : line.substr(language), {}});
      }
      in = in == In::Fence ? In::Text : In::Fence;
    } else if (in == In::Text && afterBlank && isIndented(line)) {
      blocks.push_back({{readme.path, number}, "indented", {line}});
      in = In::Indent;
    } else if (in != In::Text) {
      blocks.back().lines.push_back(line);
    }
    afterBlank = isBlank(line);
  }
  return blocks;
}

std::vector<CodeSpan> codeSpans(const Readme& readme) {
  static const std::regex pattern("`([^`]+)`");
  std::vector<CodeSpan> spans;
  for (const auto& [number, line] : prose(readme)) {
    eachMatch(line, pattern, [&, at = number](const std::string& text) { spans.push_back({{readme.path, at}, text}); });
  }
  return spans;
}

std::vector<Link> links(const Readme& readme) {
  static const std::regex markdown(R"(\]\(([^)\s]+)\))"), html("(?:src|href)=\"([^\"]+)\"");
  std::vector<Link> found;
  for (const auto& [number, line] : prose(readme)) {
    const auto add = [&, at = number](const std::string& target) { found.push_back({{readme.path, at}, target}); };
    eachMatch(line, markdown, add);
    eachMatch(line, html, add);
  }
  return found;
}

std::vector<Paragraph> paragraphs(const Readme& readme) {
  std::vector<Paragraph> found;
  bool open = false;
  for (const auto& [number, line] : prose(readme)) {
    const bool row = line.rfind('|', 0) == 0, heading = line.rfind('#', 0) == 0;
    if (isBlank(line) || heading) {
      open = false;
    } else if (open && !row) {
      found.back().lines.push_back(line);
    } else {
      found.push_back({{readme.path, number}, {line}});
      open = !row;
    }
  }
  return found;
}

std::string Paragraph::text() const {
  std::string joined;
  for (const std::string& line : lines) joined += (joined.empty() ? "" : " ") + line;
  return joined;
}

std::vector<std::string> anchors(const Readme& readme) {
  std::vector<std::string> found;
  for (const auto& [number, line] : prose(readme)) {
    if (line.rfind('#', 0) != 0) continue;
    std::string anchor;
    for (const char c : line.substr(line.find_first_not_of("# "))) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) != 0 || c == '-' || c == '_') anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ') anchor += '-';
    }
    found.push_back(anchor);
  }
  return found;
}

}  // namespace boxprobe::test
