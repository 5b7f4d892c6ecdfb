// Parses in two passes: the library checks the grammar and builds the values; then a scanner, which can rely on valid
// text, records where each key and element starts, which the library does not report.
#include "filters/io/json/json_text.h"

#include <charconv>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"

namespace boxprobe {

namespace {

TextPlace placeOf(const std::string& text, std::size_t offset) {
  TextPlace place{1, 1};
  for (std::size_t i = 0; i < offset && i < text.size(); ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) {  // UTF-8 continuation bytes count as no column
      ++place.column;
    }
  }
  return place;
}

std::string at(const std::string& name, const TextPlace& place) {
  return name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
}

/// The library's message without its code and position: "[json.exception.parse_error.101] parse error at line 1, column
/// 2: syntax error while ..." becomes "syntax error while ...".
std::string reasonOnly(const std::string& what) {
  std::size_t start = 0;
  if (const auto bracket = what.find("] "); what.rfind('[', 0) == 0 && bracket != std::string::npos)
    start = bracket + 2;
  if (what.compare(start, 11, "parse error") == 0) {
    if (const auto colon = what.find(": ", start); colon != std::string::npos) start = colon + 2;
  }
  return oneLine(what.substr(start));
}

/// Replaces the library's handler to get the position of every error: exceptions for numbers out of range have none.
struct SyntaxCheck : nlohmann::json_sax<Json> {
  SyntaxCheck(const std::string& checked, std::size_t most) : text(checked), mostEntries(most) {}
  const std::string& text;
  const std::size_t mostEntries;
  std::size_t errorOffset = 0;
  std::string reason;
  std::string tooMany;  ///< the key of the container with more than mostEntries

  bool null() override { return element(); }
  bool boolean(bool) override { return element(); }
  bool number_integer(number_integer_t) override { return element(); }
  bool number_unsigned(number_unsigned_t) override { return element(); }
  bool number_float(number_float_t, const string_t&) override { return element(); }
  bool string(string_t&) override { return element(); }
  bool binary(binary_t&) override { return element(); }
  bool start_object(std::size_t) override { return element() && open(false); }
  bool key(string_t& name) override {
    lastKey_ = name;
    return count();
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return element() && open(true); }
  bool end_array() override { return close(); }
  /// `position` is after the last character read; messages show where the token starts.
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    reason = reasonOnly(error.what());
    const std::size_t length = std::max<std::size_t>(token.size(), 1);
    const bool atToken =
        position >= length && position <= text.size() && text.compare(position - length, length, token) == 0;
    errorOffset = atToken ? position - length : position > 0 ? position - 1 : 0;
    if (reason.find("invalid literal") != std::string::npos) {
      // The library's token then holds what was read before the word as well.
      errorOffset = std::min(position > 0 ? position - 1 : 0, text.size());
      const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
      while (errorOffset > 0 && letter(text[errorOffset - 1])) --errorOffset;
    }
    return false;
  }

 private:
  struct Level {
    std::string key;
    bool array = false;
    std::size_t entries = 0;
  };
  bool open(bool array) {
    constexpr std::size_t kDeepest = 128;
    levels_.push_back({lastKey_, array, 0});
    if (levels_.size() <= kDeepest) return true;
    reason = "nested more than " + std::to_string(kDeepest) + " levels deep";
    return false;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }
  bool element() { return levels_.empty() || !levels_.back().array || count(); }
  bool count() {
    if (++levels_.back().entries <= mostEntries) return true;
    tooMany = levels_.back().key.empty() ? "the file" : oneLine(levels_.back().key);
    return false;
  }
  std::vector<Level> levels_;
  std::string lastKey_;
};

/// Scans text that is known to be valid JSON.
class PlaceScanner {
 public:
  PlaceScanner(const std::string& text, JsonText& result) : text_(text), result_(result) {}

  void scan() {
    if (text_.compare(0, 3, "\xef\xbb\xbf") == 0) position_ = counted_ = 3;  // byte order mark
    for (; position_ < text_.size(); ++position_) {
      const char c = text_[position_];
      if (c == '"') {
        string();
      } else if (c == '{' || c == '[') {
        PlacedValue* value = startValue(position_);
        inValue_ = false;
        levels_.push_back({value, c == '{', {}});
      } else if (c == '}' || c == ']') {
        levels_.pop_back();
        inValue_ = false;
      } else if (c == ',') {
        inValue_ = false;
        levels_.back().member = nullptr;
      } else if (c != ' ' && c != '\t' && c != '\n' && c != '\r' && c != ':') {
        startValue(position_);  // the first character of a number or word
      }
    }
  }

 private:
  struct Level {
    PlacedValue* value = nullptr;
    bool object = false;
    PlacedValue* member = nullptr;  ///< its key has been read
  };

  /// Offsets only grow, so each scan starts at the previous position: a megabyte on one line stays cheap.
  TextPlace here(std::size_t offset) {
    for (; counted_ < offset; ++counted_) {
      if (text_[counted_] == '\n') {
        ++place_.line;
        place_.column = 1;
      } else if ((static_cast<unsigned char>(text_[counted_]) & 0xc0) != 0x80) {
        ++place_.column;
      }
    }
    return place_;
  }

  /// What begins here: the root, a member whose key has been read, or the next element. Null within a value.
  PlacedValue* startValue(std::size_t offset) {
    if (inValue_) return nullptr;
    inValue_ = true;
    if (!levels_.empty() && levels_.back().object) return levels_.back().member;
    PlacedValue& value = levels_.empty() ? result_.places : levels_.back().value->elements.emplace_back();
    value.place = here(offset);
    return &value;
  }

  void string() {
    const std::size_t start = position_;
    for (++position_; text_[position_] != '"'; ++position_) {
      if (text_[position_] == '\\') ++position_;
    }
    if (levels_.empty() || !levels_.back().object || levels_.back().member != nullptr) {
      startValue(start);
      return;
    }
    Level& level = levels_.back();
    const auto key = Json::parse(text_.substr(start, position_ + 1 - start)).get<std::string>();  // decodes escapes
    const auto [member, added] = level.value->members.try_emplace(key);
    if (!added) {
      throw InputError(at(result_.name, here(start)) + "the key \"" + oneLine(key) +
                       "\" stands here a second time; remove one");
    }
    member->second.place = here(start);
    level.member = &member->second;
  }

  const std::string& text_;
  JsonText& result_;
  std::size_t position_ = 0, counted_ = 0;
  TextPlace place_{1, 1};  // position of counted_
  bool inValue_ = false;
  std::vector<Level> levels_;
};

constexpr std::size_t kLineWidth = 100;

void write(std::string& out, const Json& value, std::size_t indent, std::size_t used) {
  const std::string flat = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!value.is_structured() || value.empty()) {
    out += flat;
    return;
  }
  const bool object = value.is_object();
  // One line if it fits and holds only plain values or a few short lists: [1, 2], {"min": [..], "max": [..]}.
  bool simple = true;
  for (const Json& child : value) {
    if (!child.is_structured()) continue;
    simple = simple && child.is_array() && value.size() <= 3;
    for (const Json& grandchild : child) simple = simple && !grandchild.is_structured();
  }
  // Separators gain a space each when spread out, which `flat` lacks.
  const std::size_t spaced = flat.size() + 2 * value.size() + 8;
  const bool oneLine = indent > 0 && used + spaced <= kLineWidth && simple;
  const std::string pad(oneLine ? 0 : indent + 2, ' ');
  out += object ? '{' : '[';
  bool first = true;
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (!first) out += oneLine ? ", " : ",";
    first = false;
    if (!oneLine) out += "\n" + pad;
    const std::string key = object ? Json(it.key()).dump(-1, ' ', false, Json::error_handler_t::replace) + ": " : "";
    out += key;
    write(out, it.value(), indent + 2, oneLine ? 0 : pad.size() + key.size());
  }
  if (!oneLine) out += "\n" + std::string(indent, ' ');
  out += object ? '}' : ']';
}

}  // namespace

std::string JsonText::placeText(const Json::json_pointer& pointer) const {
  std::vector<std::string> keys;
  for (Json::json_pointer p = pointer; !p.empty(); p.pop_back()) keys.push_back(p.back());
  const PlacedValue* value = &places;
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    const PlacedValue* next = nullptr;
    if (const auto member = value->members.find(*key); member != value->members.end()) {
      next = &member->second;
    } else if (std::size_t index = 0; !value->elements.empty()) {
      const auto read = std::from_chars(key->data(), key->data() + key->size(), index);
      if (read.ec == std::errc() && index < value->elements.size()) next = &value->elements[index];
    }
    if (next == nullptr) break;
    value = next;
  }
  if (value->place.line == 0) return name;
  return name + ":" + std::to_string(value->place.line) + ":" + std::to_string(value->place.column);
}

void checkJsonSyntax(const std::string& text, const std::string& name, std::size_t mostEntries) {
  SyntaxCheck check(text, mostEntries);
  if (Json::sax_parse(text, &check)) return;
  if (!check.tooMany.empty()) {
    throw InputError(name + ": " + check.tooMany + ": has more than " + std::to_string(mostEntries) +
                     " entries, the most that are read; leave some out");
  }
  const std::string place = check.errorOffset > 0 ? at(name, placeOf(text, check.errorOffset)) : name + ": ";
  throw InputError(place + "not valid JSON: " + check.reason);
}

JsonText parseJsonText(const std::string& text, const std::string& name) {
  // The library treats a zero byte as the end of the text without an error; the scanner below would continue.
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
    throw InputError(at(name, placeOf(text, zero)) + "not valid JSON: there is a zero byte; save it as plain text");
  }
  checkJsonSyntax(text, name, limits::kEntries);
  JsonText result;
  result.name = name;
  result.root = Json::parse(text);
  PlaceScanner(text, result).scan();
  return result;
}

std::string formatJson(const Json& value) {
  std::string out;
  write(out, value, 0, 0);
  return out + "\n";
}

}  // namespace boxprobe
