#include "filters/io/obj/obj_text.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>

#include "filters/core/base/read_number.h"

namespace boxprobe {

namespace {

constexpr std::string_view kBetween = " \t\r";

}  // namespace

ObjLines::ObjLines(const std::string& bytes) : bytes_(bytes) {
  if (bytes_.substr(0, 3) == "\xef\xbb\xbf") at_ = 3;
}

std::string_view ObjLines::nextRaw() {
  const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
  const std::string_view line = bytes_.substr(at_, end - at_);
  const bool pair = end + 1 < bytes_.size() && bytes_[end] == '\r' && bytes_[end + 1] == '\n';
  at_ = end + (pair ? 2 : 1);
  ++raw_;
  return line;
}

bool ObjLines::next(std::string_view& line) {
  if (at_ >= bytes_.size()) return false;
  line = trimmedText(nextRaw());
  number_ = raw_;
  // A comment may end with a path.
  const bool continues = !line.empty() && line.back() == '\\' && line.front() != '#';
  if (!continues) return true;
  joined_.clear();
  for (;;) {
    const bool more = !line.empty() && line.back() == '\\';
    joined_ += more ? line.substr(0, line.size() - 1) : line;
    if (!more || at_ >= bytes_.size()) break;
    joined_ += ' ';
    line = trimmedText(nextRaw());
  }
  line = trimmedText(joined_);
  return true;
}

std::string utf8Text(std::string bytes) {
  const bool little = bytes.compare(0, 2, "\xff\xfe") == 0, big = bytes.compare(0, 2, "\xfe\xff") == 0;
  if (!little && !big) return bytes;
  std::string text;
  const auto unitAt = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])); };
    return little ? byte(at) | (byte(at + 1) << 8) : (byte(at) << 8) | byte(at + 1);
  };
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unitAt(at);
    if (code >= 0xd800 && code < 0xdc00 && at + 3 < bytes.size()) {  // the first half of a pair
      code = 0x10000 + ((code - 0xd800) << 10) + ((unitAt(at + 2) - 0xdc00) & 0x3ff);
      at += 2;
    }
    const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xc0 | (code >> 6));
      tail(0);
    } else if (code < 0x10000) {
      text += static_cast<char>(0xe0 | (code >> 12));
      tail(6);
      tail(0);
    } else {
      text += static_cast<char>(0xf0 | (code >> 18));
      tail(12);
      tail(6);
      tail(0);
    }
  }
  return text;
}

std::string_view trimmedText(std::string_view text) {
  const std::size_t from = text.find_first_not_of(kBetween);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kBetween) - from + 1);
}

std::string_view nextObjWord(std::string_view& rest) {
  rest = trimmedText(rest);
  const std::size_t end = std::min(rest.find_first_of(kBetween), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return word;
}

std::string_view nextObjValue(std::string_view& rest) {
  const std::string_view word = nextObjWord(rest);
  if (word.empty() || word.front() != '#') return word;
  rest = {};
  return {};
}

std::string unquoted(std::string_view text) {
  text = trimmedText(text);
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

std::string lowerText(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool readObjNumber(std::string_view word, double& value) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  if (word.find("#IN") != std::string_view::npos || word.find("#QNAN") != std::string_view::npos) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const auto result = readNumber(word.data(), word.data() + word.size(), value);
  if (result.ec == std::errc::invalid_argument || result.ptr != word.data() + word.size()) return false;
  if (result.ec == std::errc::result_out_of_range) {
    const bool small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    value = small ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  }
  return true;
}

}  // namespace boxprobe
