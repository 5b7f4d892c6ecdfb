// JSON as text with places: parsing that knows line and column of every value, and writing that people like to read.
// Called by the scene reader and writer; knows JSON, not scenes.
#pragma once

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace boxprobe {

using Json = nlohmann::ordered_json;

struct TextPlace {
  std::size_t line = 0;  ///< from 1; 0: not known
  std::size_t column = 0;
};

struct JsonText {
  std::string name;  ///< of the file, for messages
  Json root;
  std::map<std::string, TextPlace> places;  ///< by JSON pointer ("/probes/0/box"): where the key, or element, starts

  /// "scene.json:12:9", for the value or the nearest one around it that stands in the text.
  std::string placeText(const Json::json_pointer& pointer) const;
};

/// Throws InputError ("scene.json:3:14: ...") for what is not JSON, or is nested deeper than any honest file: the
/// libraries that read values recurse. So it does for a list or object of more than `mostEntries`.
void checkJsonSyntax(const std::string& text, const std::string& name,
                     std::size_t mostEntries = std::numeric_limits<std::size_t>::max());

/// Throws InputError ("scene.json:3:14: ...") for what is not JSON, for numbers beyond double, for a key given twice
/// and for a list or object of more than 10000 entries.
JsonText parseJsonText(const std::string& text, const std::string& name);

/// Indented by two; an array or object that holds no long ones stays on one line while that has room. Ends in a
/// newline.
std::string formatJson(const Json& value);

}  // namespace boxprobe
