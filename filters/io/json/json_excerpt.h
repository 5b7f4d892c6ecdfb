// A JSON value in a message.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace boxprobe {

/// The value as text, shortened; of nlohmann's values with ordered members and of those without.
template <class AnyJson>
std::string excerpt(const AnyJson& value) {
  if (value.is_object()) return "an object";
  if (value.is_array() && value.size() > 4) return "a list of " + std::to_string(value.size());
  std::string text = value.dump(-1, ' ', false, AnyJson::error_handler_t::replace);
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) text = text.substr(0, kLongest - 3) + "...";
  return text;
}

}  // namespace boxprobe
