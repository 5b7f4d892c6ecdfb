// A JSON value with its key path: every accessor checks the type and throws a FieldError with that path.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/base/field_error.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

class JsonCursor {
 public:
  JsonCursor(const Json& value, KeyPath path) : value_(&value), path_(std::move(path)) {}

  const Json& json() const { return *value_; }
  const KeyPath& path() const { return path_; }
  /// The same value under another path: a list entry once its name is known.
  JsonCursor at(KeyPath path) const { return {*value_, std::move(path)}; }

  [[noreturn]] void fail(const std::string& reason) const { throw FieldError(path_, reason); }

  /// Throws unless it is an object whose keys are all in `known`; suggests the nearest key.
  void requireObject(const std::vector<std::string>& known) const;
  void requireObject() const;
  void requireArray() const;

  std::optional<JsonCursor> find(std::string_view key) const;  ///< of an object; call requireObject() first
  std::vector<JsonCursor> elements() const;                    ///< of an array
  std::vector<JsonCursor> members() const;                     ///< of an object, in file order
  const std::string& key() const { return path_.back(); }

  double number() const;
  float numberFloat() const;  ///< throws for values beyond float's range
  int whole() const;
  bool boolean() const;
  std::string text() const;
  glm::dvec2 pair() const;
  glm::dvec3 vector() const;
  glm::vec3 color() const;
  /// The index of the text in `choices`.
  std::size_t choice(const std::vector<std::string_view>& choices) const;

 private:
  [[noreturn]] void wrongType(const std::string& wanted) const;
  const Json* value_;
  KeyPath path_;
};

}  // namespace boxprobe
