// Documents as every reader of JSON takes them, whatever names hold. Called by all that writes results as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace boxprobe {

/// With a line end; bytes that are no UTF-8 become U+FFFD. `indent` -1: on one line.
inline std::string validJson(const nlohmann::ordered_json& json, int indent = 2) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace boxprobe
