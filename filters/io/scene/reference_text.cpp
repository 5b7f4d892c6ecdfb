// See reference_text.h.
#include "filters/io/scene/reference_text.h"

#include "filters/core/base/number_text.h"

namespace boxprobe {

std::string quotedId(std::string_view text) {
  return "`\"" + std::string(text) + "\"`";
}

namespace {

/// The kind of a value, without range and unit.
std::string kindText(const FieldInfo& field) {
  switch (field.kind) {
    case FieldKind::Number:
      return "number";
    case FieldKind::Integer:
      return field.values.empty() ? "whole number" : "";
    case FieldKind::Boolean:
      return "`true` or `false`";
    case FieldKind::File:
      return "file name";
    case FieldKind::Choice:
      return joined(field.choices, ", ", [](const FieldChoice& choice) { return quotedId(choice.id); });
    case FieldKind::Vector:
    case FieldKind::Direction:
      return "[x, y, z]";
    case FieldKind::Color:
      return "[r, g, b]";
    case FieldKind::Names:
      return "list of names";
    default:
      return "text";
  }
}

bool isNumber(const FieldInfo& field) {
  return field.kind == FieldKind::Number || field.kind == FieldKind::Integer;
}

bool isTriple(const FieldInfo& field) {
  return field.kind == FieldKind::Vector || field.kind == FieldKind::Color;
}

}  // namespace

std::string valueText(const FieldInfo& field) {
  std::string text = field.written.empty() ? kindText(field) : std::string(field.written);
  const std::string range = isNumber(field) || isTriple(field) ? rangeText(field) : "";
  if (field.written.empty() && !range.empty()) {
    const bool sentence = range.rfind("from", 0) == 0 || range.rfind("greater", 0) == 0;
    text += text.empty() ? range : isTriple(field) ? ", each " + range : (sentence ? " " : ", ") + range;
  }
  return text + (field.unit.empty() ? "" : ", " + std::string(field.unit));
}

std::string valueText(const ParameterRow& row) {
  if (row.kind == ParameterKind::Choice) return joined(row.choices, ", ", quotedId);
  if (row.kind == ParameterKind::Switch) return "`true` or `false`";
  return std::string(row.kind == ParameterKind::WholeNumber ? "whole number" : "number") + " from " +
         numberText(row.min) + " to " + numberText(row.max) + (row.unit.empty() ? "" : ", " + std::string(row.unit));
}

std::string typeText(const FieldInfo& field) {
  if (field.types == ~0u) return "";
  std::string list;
  const std::vector<FieldChoice>& types = lightField("type").choices;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if ((field.types >> i & 1u) != 0) list += (list.empty() ? "" : " or ") + std::string(types[i].id);
  }
  return list;
}

const ChangeRow& changeRow(bool Changes::*kind) {
  for (const ChangeRow& row : changeRows()) {
    if (row.member == kind) return row;
  }
  return changeRows().front();  // every member has a row
}

}  // namespace boxprobe
