// See json_values.h.
#include "tests/compare/json_values.h"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace boxprobe::compare {

namespace {

using Json = nlohmann::json;

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Every number that stands in a text.
void addNumbersOfText(const std::string& text, const std::string& path, JsonValues& values) {
  std::size_t count = 0;
  for (const char* at = text.c_str(); *at != '\0';) {
    const bool number = std::isdigit(static_cast<unsigned char>(*at)) != 0 ||
                        (*at == '-' && std::isdigit(static_cast<unsigned char>(at[1])) != 0);
    char* end = nullptr;
    const double value = number ? std::strtod(at, &end) : 0.0;
    if (number) values.numbers[path + "#" + std::to_string(count++)] = value;
    at = number ? end : at + 1;
  }
}

void add(const Json& json, const std::string& key, const std::string& place, JsonValues& values) {
  if (!key.empty()) values.keys.insert(key);
  if (json.is_object()) {
    for (const auto& member : json.items()) {
      const std::string dot = key.empty() ? "" : ".";
      add(member.value(), key + dot + member.key(), place + (place.empty() ? "" : ".") + member.key(), values);
    }
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      add(json[i], key + "[]", place + "[" + std::to_string(i) + "]", values);
    }
  } else if (json.is_number()) {
    values.numbers[place] = json.get<double>();
  } else if (json.is_boolean()) {
    values.numbers[place] = json.get<bool>() ? 1.0 : 0.0;
  } else if (json.is_string() && place.size() > 8 && place.compare(place.size() - 8, 8, "measured") == 0) {
    addNumbersOfText(json.get<std::string>(), place, values);
  }
}

}  // namespace

JsonValues readJson(const std::string& path) {
  const std::string text = textOf(path);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) {
    json = Json::array();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) json.push_back(Json::parse(line, nullptr, false));
  }
  JsonValues values;
  add(json, "", "", values);
  if (values.keys.empty()) throw std::runtime_error(path + ": not JSON");
  return values;
}

std::vector<std::string> namesInJson(const std::string& path, const std::string& list) {
  const Json json = Json::parse(textOf(path), nullptr, false);
  if (!json.is_object() || !json.contains(list)) throw std::runtime_error(path + ": no list " + list);
  std::vector<std::string> names;
  for (const Json& element : json[list]) names.push_back(element.at("name").get<std::string>());
  return names;
}

bool changesByRun(const std::string& path) {
  static const std::regex pattern("[sS]econds|peakResident|frameCpu|[cC]puRatio|onFront|pairs|spread");
  return std::regex_search(path, pattern);
}

}  // namespace boxprobe::compare
