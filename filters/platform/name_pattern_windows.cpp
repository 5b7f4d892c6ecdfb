// See name_pattern.h. Windows' own patterns have neither sets nor a way to write a star.
#include <algorithm>
#include <vector>

#include "filters/platform/name_pattern.h"

namespace boxprobe {

namespace {

/// One place of a pattern: any text, or a set of letters.
struct Place {
  bool anyText = false;
  bool none = false;  ///< of the ranges
  std::vector<std::pair<char32_t, char32_t>> ranges;

  bool takes(char32_t letter) const {
    const bool within = std::any_of(ranges.begin(), ranges.end(), [letter](const auto& range) {
      return range.first <= letter && letter <= range.second;
    });
    return within != none;
  }
};

std::u32string letters(const std::string& text) {
  std::u32string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0u) == 0x80u && !result.empty()) {
      result.back() = result.back() << 6u | (byte & 0x3Fu);
    } else {
      result.push_back(byte < 0xC0u ? byte : byte < 0xE0u ? byte & 0x1Fu : byte < 0xF0u ? byte & 0x0Fu : byte & 0x07u);
    }
  }
  return result;
}

/// The place of a set that starts at `at`, behind its bracket; `at` is then behind its end. False if it has no end.
bool readSet(const std::u32string& pattern, std::size_t& at, Place& place) {
  std::size_t next = at;
  place.none = next < pattern.size() && (pattern[next] == U'!' || pattern[next] == U'^');
  if (place.none) ++next;
  for (const std::size_t first = next; next < pattern.size(); ++next) {
    if (pattern[next] == U']' && next > first) {
      at = next + 1;
      return true;
    }
    if (pattern[next] == U'\\' && next + 1 < pattern.size()) ++next;
    const char32_t low = pattern[next];
    char32_t high = low;
    if (next + 2 < pattern.size() && pattern[next + 1] == U'-' && pattern[next + 2] != U']') high = pattern[next += 2];
    place.ranges.emplace_back(low, high);
  }
  return false;
}

std::vector<Place> placesOf(const std::u32string& pattern) {
  std::vector<Place> places;
  for (std::size_t at = 0; at < pattern.size();) {
    Place place;
    const char32_t letter = pattern[at++];
    if (letter == U'*') {
      place.anyText = true;
    } else if (letter == U'?') {
      place.none = true;
    } else if (letter != U'[' || !readSet(pattern, at, place)) {
      const char32_t itself = letter == U'\\' && at < pattern.size() ? pattern[at++] : letter;
      place = Place();
      place.ranges.emplace_back(itself, itself);
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace

bool matchesPattern(const std::string& pattern, const std::string& name) {
  const std::vector<Place> places = placesOf(letters(pattern));
  const std::u32string text = letters(name);
  // The last star may take one letter more whenever what follows it does not match: no earlier one needs to.
  std::size_t place = 0, at = 0, star = places.size(), starTook = 0;
  while (at < text.size()) {
    if (place < places.size() && places[place].anyText) {
      star = place++;
      starTook = at;
    } else if (place < places.size() && places[place].takes(text[at])) {
      ++place;
      ++at;
    } else if (star < places.size()) {
      place = star + 1;
      at = ++starTook;
    } else {
      return false;
    }
  }
  return std::all_of(places.begin() + static_cast<std::ptrdiff_t>(place), places.end(),
                     [](const Place& rest) { return rest.anyText; });
}

}  // namespace boxprobe
