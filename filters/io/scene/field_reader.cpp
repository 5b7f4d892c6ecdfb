// Reads one field's value from JSON by the kind of its row. validate() checks ranges.
#include <filesystem>

#include "filters/core/scene/bounces.h"
#include "filters/io/scene/field_json.h"

namespace boxprobe {

namespace {

std::string resolved(const std::string& file, const std::string& folder) {
  if (folder.empty() || file.empty()) return file;
  return (std::filesystem::path(folder) / file).lexically_normal().string();  // an absolute `file` replaces the folder
}

std::size_t choiceOf(const JsonCursor& value, const FieldInfo& field) {
  std::vector<std::string_view> ids;
  for (const FieldChoice& choice : field.choices) ids.push_back(choice.id);
  return value.choice(ids);
}

std::vector<std::string> readNames(const JsonCursor& value) {
  std::vector<std::string> names;
  for (const JsonCursor& element : value.elements()) names.push_back(element.text());
  return names;
}

BlendDistance readBlendDistance(const JsonCursor& value) {
  if (value.json().is_number()) {
    const double distance = value.number();
    return {glm::dvec3(distance), glm::dvec3(distance)};
  }
  if (!value.json().is_object()) value.fail("must be a number, or {\"min\": [..], \"max\": [..]}");
  return readPart(value, blendDistanceFields(), "");
}

Clear readClear(const JsonCursor& value) {
  if (value.json().is_array()) return value.color();
  if (value.json() == "sky") return ClearToSky{};
  if (value.json() == "none") return ClearToNone{};
  if (value.json() == "open") return ClearToOpen{};
  value.fail("must be \"sky\", \"open\", \"none\" or a color [r, g, b]");
}

Bevel readBevel(const JsonCursor& value) {
  if (value.json().is_number()) return {value.number(), 0.0};
  if (!value.json().is_object()) value.fail("must be a radius, or {\"fromRoughness\": FACTOR}");
  return readPart(value, bevelFields(), "");
}

ProbeLattice readLattice(const JsonCursor& value) {
  if (value.json().is_boolean() && !value.boolean()) return {false};
  if (!value.json().is_object()) value.fail("must be false, or {\"spacing\": DISTANCE}");
  return readPart(value, latticeFields(), "");
}

ParameterValue readParameter(const JsonCursor& value) {
  if (value.json().is_boolean()) return value.boolean();
  if (value.json().is_number()) return value.number();
  if (value.json().is_string()) return value.text();
  value.fail("must be a number, true or false, or text in quotes");
}

std::map<std::string, ParameterValue> readParameters(const JsonCursor& value) {
  std::map<std::string, ParameterValue> parameters;
  for (const JsonCursor& parameter : value.members()) parameters[parameter.key()] = readParameter(parameter);
  return parameters;
}

/// A whole number, or the word that stands for all.
int readWholeOrWord(const JsonCursor& value, const FieldInfo& field) {
  const std::string word(field.choices.front().id);
  if (value.json() == word) return kAllBounces;
  const bool known = value.json().is_number_integer() && value.json() != kAllBounces;
  if (!known) value.fail("must be a whole number " + rangeText(field) + ", or \"" + word + "\"");
  return value.whole();
}

}  // namespace

FieldValue readValue(const JsonCursor& value, const FieldInfo& field, const std::string& folder) {
  switch (field.kind) {
    case FieldKind::Number:
      return field.singlePrecision ? FieldValue(value.numberFloat()) : FieldValue(value.number());
    case FieldKind::Integer:
      return field.choices.empty() ? value.whole() : readWholeOrWord(value, field);
    case FieldKind::Boolean:
      return value.boolean();
    case FieldKind::Text:
      return value.text();
    case FieldKind::File:
      return resolved(value.text(), folder);
    case FieldKind::Choice:
      return static_cast<int>(choiceOf(value, field));
    case FieldKind::Vector:
    case FieldKind::Direction:
      return value.vector();
    case FieldKind::Color:
      return value.color();
    case FieldKind::Decode:
      return value.pair();
    case FieldKind::Names:
      return readNames(value);
    case FieldKind::Parameters:
      return readParameters(value);
    case FieldKind::Box:
      return readPart(value, boxFields(), "");
    case FieldKind::BlendDistance:
      return readBlendDistance(value);
    case FieldKind::Bevel:
      return readBevel(value);
    case FieldKind::Occlusion:
      return readPart(value, occlusionFields(), "");
    case FieldKind::LatticeOrNone:
      return readLattice(value);
    case FieldKind::ClearTo:
      return readClear(value);
    case FieldKind::Parts:
      break;
  }
  return {};
}

}  // namespace boxprobe
