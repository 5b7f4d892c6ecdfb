// Type checks; see the header.
#include "filters/io/json/json_cursor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/core/base/nearest_name.h"
#include "filters/io/json/json_excerpt.h"

namespace boxprobe {

void JsonCursor::wrongType(const std::string& wanted) const {
  fail("must be " + wanted + ", not " + excerpt(*value_));
}

void JsonCursor::requireObject() const {
  if (!value_->is_object()) wrongType("an object in braces");
}

void JsonCursor::requireObject(const std::vector<std::string>& known) const {
  requireObject();
  for (const auto& item : value_->items()) {
    if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
    const std::string guess = didYouMean(item.key(), known);
    KeyPath path = path_;
    path.push_back(item.key());
    throw FieldError(path,
                     "unknown key" + (guess.empty() ? "; the keys here are " + nameList(known, known.size()) : guess));
  }
}

void JsonCursor::requireArray() const {
  if (!value_->is_array()) wrongType("a list in brackets");
}

std::optional<JsonCursor> JsonCursor::find(std::string_view key) const {
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) return std::nullopt;
  KeyPath path = path_;
  path.emplace_back(key);
  return JsonCursor(*found, std::move(path));
}

std::vector<JsonCursor> JsonCursor::elements() const {
  requireArray();
  std::vector<JsonCursor> list;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    KeyPath path = path_;
    path.push_back("[" + std::to_string(i) + "]");
    list.emplace_back((*value_)[i], std::move(path));
  }
  return list;
}

std::vector<JsonCursor> JsonCursor::members() const {
  requireObject();
  std::vector<JsonCursor> list;
  for (const auto& item : value_->items()) {
    KeyPath path = path_;
    path.push_back(item.key());
    list.emplace_back(item.value(), std::move(path));
  }
  return list;
}

double JsonCursor::number() const {
  if (!value_->is_number()) wrongType("a number");
  return value_->get<double>();
}

float JsonCursor::numberFloat() const {
  const double value = number();
  if (std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max())) {
    fail(excerpt(*value_) + " is too large; use a smaller number");
  }
  return static_cast<float>(value);
}

int JsonCursor::whole() const {
  const double value = number();
  if (std::floor(value) != value || std::fabs(value) > std::numeric_limits<int>::max()) wrongType("a whole number");
  return static_cast<int>(value);
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) wrongType("true or false");
  return value_->get<bool>();
}

std::string JsonCursor::text() const {
  if (!value_->is_string()) wrongType("text in quotes");
  return value_->get<std::string>();
}

glm::dvec2 JsonCursor::pair() const {
  if (!value_->is_array() || value_->size() != 2) wrongType("two numbers in brackets");
  const std::vector<JsonCursor> list = elements();
  return {list[0].number(), list[1].number()};
}

glm::dvec3 JsonCursor::vector() const {
  if (!value_->is_array() || value_->size() != 3) wrongType("three numbers in brackets");
  const std::vector<JsonCursor> list = elements();
  return {list[0].number(), list[1].number(), list[2].number()};
}

glm::vec3 JsonCursor::color() const {
  if (!value_->is_array() || value_->size() != 3) wrongType("three numbers in brackets");
  const std::vector<JsonCursor> list = elements();
  return {list[0].numberFloat(), list[1].numberFloat(), list[2].numberFloat()};
}

std::size_t JsonCursor::choice(const std::vector<std::string_view>& choices) const {
  if (value_->is_string()) {
    std::size_t index = 0;
    for (const std::string_view choice : choices) {
      if (value_->get_ref<const std::string&>() == choice) return index;
      ++index;
    }
  }
  std::string list;
  for (const std::string_view choice : choices) list += (list.empty() ? "\"" : ", \"") + std::string(choice) + "\"";
  wrongType("one of " + list);
}

}  // namespace boxprobe
