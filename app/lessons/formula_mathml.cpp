// See formula_mathml.h. Recursive descent: a row of items, each an atom with what is below and above it.
#include "app/lessons/formula_mathml.h"

#include <cctype>
#include <map>
#include <string_view>

namespace boxprobe {

namespace {

constexpr int kDeepest = 32;  // groups within groups: beyond it the text is shown as it stands

const std::map<std::string, std::string>& operators() {
  static const std::map<std::string, std::string> table = {
      {"cdot", "\u22c5"}, {"times", "\u00d7"}, {"le", "\u2264"},   {"ge", "\u2265"},    {"approx", "\u2248"},
      {"ne", "\u2260"},   {"to", "\u2192"},    {"pm", "\u00b1"},   {"infty", "\u221e"}, {"ldots", "\u2026"},
      {"sum", "\u2211"},  {"in", "\u2208"},    {"quad", "\u2003"}, {"propto", "\u221d"}};
  return table;
}

const std::map<std::string, std::string>& letters() {
  static const std::map<std::string, std::string> table = {
      {"alpha", "\u03b1"},  {"beta", "\u03b2"},   {"theta", "\u03b8"}, {"omega", "\u03c9"}, {"pi", "\u03c0"},
      {"lambda", "\u03bb"}, {"Lambda", "\u039b"}, {"eta", "\u03b7"},   {"sigma", "\u03c3"}};
  return table;
}

bool isFunction(const std::string& name) {
  for (const char* known : {"min", "max", "clamp", "mix", "sin", "cos", "dot", "exp", "log", "saturate"}) {
    if (name == known) return true;
  }
  return false;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  std::string row(bool inGroup, int depth) {
    std::string result;
    for (skipSpace(); at_ < text_.size(); skipSpace()) {
      if (text_[at_] == '}') {
        if (inGroup) break;
        result += element("mo", "}");
        ++at_;
        continue;
      }
      result += item(depth);
    }
    return result;
  }

 private:
  void skipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  std::string item(int depth) {
    bool limits = false;
    const std::string base = atom(depth, &limits);
    std::string below, above;
    for (skipSpace(); at_ < text_.size() && (text_[at_] == '_' || text_[at_] == '^'); skipSpace()) {
      std::string& script = text_[at_++] == '_' ? below : above;
      skipSpace();
      script = at_ < text_.size() ? atom(depth, nullptr) : element("mrow", "");
    }
    if (below.empty() && above.empty()) return base;
    if (!below.empty() && !above.empty()) return element("msubsup", base + below + above);
    if (!above.empty()) return element("msup", base + above);
    return element(limits ? "munder" : "msub", base + below);
  }

  std::string group(int depth) {
    skipSpace();
    if (at_ >= text_.size() || text_[at_] != '{')
      return at_ < text_.size() ? atom(depth, nullptr) : element("mrow", "");
    ++at_;
    const std::string content = row(true, depth + 1);
    if (at_ < text_.size()) ++at_;
    return element("mrow", content);
  }

  std::string words() {
    skipSpace();
    if (at_ >= text_.size() || text_[at_] != '{') return element("mtext", "");
    const std::size_t end = text_.find('}', at_);
    const std::string content = text_.substr(at_ + 1, end == std::string::npos ? end : end - at_ - 1);
    at_ = end == std::string::npos ? text_.size() : end + 1;
    return element("mtext", escaped(content));
  }

  std::string command(int depth, bool* limits) {
    const std::size_t start = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    const std::string name = text_.substr(start, at_ - start);
    if (depth < kDeepest) {
      if (name == "frac") {
        const std::string numerator = group(depth);
        return element("mfrac", numerator + group(depth));
      }
      if (name == "sqrt") return element("msqrt", group(depth));
    }
    if (name == "text") return words();
    if (isFunction(name)) {
      if (limits != nullptr) *limits = name == "min" || name == "max";
      return "<mi mathvariant=\"normal\">" + name + "</mi>";
    }
    if (const auto found = operators().find(name); found != operators().end()) return element("mo", found->second);
    if (const auto found = letters().find(name); found != letters().end()) return element("mi", found->second);
    return element("mtext", escaped("\\" + name));
  }

  std::string atom(int depth, bool* limits) {
    const char c = text_[at_];
    if (c == '{' && depth < kDeepest) return group(depth);
    if (c == '\\') {
      ++at_;
      return command(depth, limits);
    }
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      const std::size_t start = at_;
      while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.'))
        ++at_;
      return element("mn", text_.substr(start, at_ - start));
    }
    // One character, of as many bytes as UTF-8 gives it.
    const std::size_t start = at_++;
    while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xC0U) == 0x80U) ++at_;
    const std::string character = text_.substr(start, at_ - start);
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      if (at_ < text_.size() && text_[at_] == '\'') {
        ++at_;
        return element("msup", element("mi", character) + element("mo", "\u2032"));
      }
      return element("mi", character);
    }
    if (c == '-') return element("mo", "\u2212");
    return element("mo", escaped(character));
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string formulaMathml(const std::string& markup) {
  return "<mrow>" + Parser(markup).row(false, 0) + "</mrow>";
}

}  // namespace boxprobe
