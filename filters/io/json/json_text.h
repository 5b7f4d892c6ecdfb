// JSON text with positions: a parser that records line and column of every value, and a readable formatter.
#pragma once

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace boxprobe {

using Json = nlohmann::ordered_json;

struct TextPlace {
  std::size_t line = 0;  ///< from 1; 0: unknown
  std::size_t column = 0;
};

/// Where a value stands, and what is in it. A tree, for the paths of a list's elements all begin with the same keys.
struct PlacedValue {
  TextPlace place;  ///< of its key, if it has one
  std::vector<PlacedValue> elements;
  std::map<std::string, PlacedValue> members;
};

struct JsonText {
  std::string name;  ///< of the file, for messages
  Json root;
  PlacedValue places;  ///< of the root

  /// "scene.json:12:9", for the value or its nearest ancestor with a known position.
  std::string placeText(const Json::json_pointer& pointer) const;
};

/// Throws InputError ("scene.json:3:14: ...") for invalid JSON, for nesting deeper than any real file's, because the
/// libraries that read values recurse, and for a list or object of more than `mostEntries`.
void checkJsonSyntax(const std::string& text, const std::string& name,
                     std::size_t mostEntries = std::numeric_limits<std::size_t>::max());

/// Throws InputError ("scene.json:3:14: ...") for invalid JSON, numbers beyond double, duplicate keys, and lists or
/// objects of more than 10000 entries.
JsonText parseJsonText(const std::string& text, const std::string& name);

/// Indented by two; an array or object without long elements stays on one line if it fits. Ends with a newline.
std::string formatJson(const Json& value);

}  // namespace boxprobe
