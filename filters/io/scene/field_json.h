// Converts scene fields to and from JSON by their rows. Internal to this folder.
#pragma once

#include "filters/core/scene/scene_fields.h"
#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

/// The keys of a part, for JsonCursor::requireObject().
template <typename... Parts>
std::vector<std::string> fieldKeys(const std::vector<FieldRow<Parts>>&... tables) {
  std::vector<std::string> keys;
  const auto add = [&keys](const auto& rows) {
    for (const auto& row : rows) keys.emplace_back(row.key);
  };
  (add(tables), ...);
  return keys;
}

/// One value. File names are resolved against `folder`. Throws FieldError for a wrong type, not for a range.
FieldValue readValue(const JsonCursor& value, const FieldInfo& field, const std::string& folder);

/// Throws FieldError if a required key is missing.
template <typename Part>
void requireFields(const JsonCursor& object, const std::vector<FieldRow<Part>>& rows) {
  for (const FieldRow<Part>& row : rows) {
    if (row.required.empty() || object.find(row.key)) continue;
    object.fail("has no " + std::string(row.key) + "; " + std::string(row.required));
  }
}

/// Reads an object whose keys were checked; fields that it lacks keep their values.
template <typename Part>
void readFields(const JsonCursor& object, const std::vector<FieldRow<Part>>& rows, Part& part,
                const std::string& folder) {
  for (const FieldRow<Part>& row : rows) {
    if (row.set == nullptr) continue;
    if (const auto value = object.find(row.key)) row.set(part, readValue(*value, row, folder));
  }
}

/// Reads a whole part from an object with its keys and no others.
template <typename Part>
Part readPart(const JsonCursor& object, const std::vector<FieldRow<Part>>& rows, const std::string& folder) {
  object.requireObject(fieldKeys(rows));
  requireFields(object, rows);
  Part part;
  readFields(object, rows, part, folder);
  return part;
}

struct Writing {
  std::string folder;  ///< file names are written relative to it; "" leaves them unchanged
  JsonForm form = JsonForm::Minimal;
};

/// One value; null for an optional that is left out.
Json valueJson(const FieldValue& value, const FieldInfo& field, const Writing& how);

/// Adds the key, unless the form leaves it out.
template <typename Part>
void writeField(Json& object, const FieldRow<Part>& row, const Part& part, const Part& standard, const Writing& how) {
  if (row.get == nullptr) return;
  if (!row.alwaysWritten && how.form == JsonForm::Minimal && row.equal(part, standard)) return;
  const FieldValue value = row.get(part);
  if (std::holds_alternative<std::monostate>(value)) return;
  const auto* file = row.kind == FieldKind::File ? std::get_if<std::string>(&value) : nullptr;
  if (file != nullptr && file->empty() && !row.alwaysWritten) return;  // no file name
  object[std::string(row.key)] = valueJson(value, row, how);
}

template <typename Part>
Json writtenPart(const std::vector<FieldRow<Part>>& rows, const Part& part, const Writing& how) {
  Json object = Json::object();
  static const Part standard;
  for (const FieldRow<Part>& row : rows) writeField(object, row, part, standard, how);
  return object;
}

}  // namespace boxprobe
