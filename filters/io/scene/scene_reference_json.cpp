// The reference as JSON.
#include <cmath>

#include "filters/core/base/file_limits.h"
#include "filters/io/scene/field_json.h"
#include "filters/io/scene/reference_text.h"
#include "filters/io/scene/scene_reference.h"

namespace boxprobe {

namespace {

const char* kindId(FieldKind kind) {
  switch (kind) {
    case FieldKind::Number:
      return "number";
    case FieldKind::Integer:
      return "integer";
    case FieldKind::Boolean:
      return "boolean";
    case FieldKind::Text:
      return "text";
    case FieldKind::File:
      return "file";
    case FieldKind::Choice:
      return "choice";
    case FieldKind::Vector:
      return "vector";
    case FieldKind::Direction:
      return "direction";
    case FieldKind::Color:
      return "color";
    case FieldKind::Decode:
      return "decode";
    case FieldKind::Names:
      return "names";
    case FieldKind::Parameters:
      return "parameters";
    case FieldKind::Box:
      return "box";
    case FieldKind::BlendDistance:
      return "blendDistance";
    case FieldKind::Bevel:
      return "bevel";
    case FieldKind::Occlusion:
      return "occlusion";
    case FieldKind::LatticeOrNone:
      return "lattice";
    case FieldKind::ClearTo:
      return "clear";
    case FieldKind::Parts:
      return "parts";
  }
  return "";
}

Json changesJson(const std::vector<bool Changes::*>& kinds) {
  Json list = Json::array();
  for (bool Changes::*kind : kinds) list.push_back(changeRow(kind).id);
  return list;
}

Json fieldJson(const FieldInfo& field, const FieldValue& standard, const FieldPart& part) {
  Json json = {{"key", field.key}, {"kind", kindId(field.kind)}, {"value", valueText(field)}, {"help", field.help}};
  if (!field.unit.empty()) json["unit"] = field.unit;
  const bool number = field.kind == FieldKind::Number || field.kind == FieldKind::Integer ||
                      field.kind == FieldKind::Vector || field.kind == FieldKind::Color;
  const FieldRange& r = field.range;
  if (number && std::fabs(r.lowest) < limits::kNumber) json[r.aboveLowest ? "above" : "lowest"] = r.lowest;
  if (number && std::fabs(r.highest) < limits::kNumber) json[r.belowHighest ? "below" : "highest"] = r.highest;
  if (!field.values.empty()) json["values"] = field.values;
  for (const FieldChoice& choice : field.choices) json["choices"].push_back({{"id", choice.id}, {"help", choice.help}});
  if (!typeText(field).empty()) json["types"] = typeText(field);
  json["required"] = !field.required.empty();
  if (field.required.empty() && field.ifLeftOut.empty()) json["default"] = valueJson(standard, field, {});
  if (!field.ifLeftOut.empty()) json["leftOut"] = field.ifLeftOut;
  json["changes"] = changesJson(field.changes.empty() ? part.changes : field.changes);
  return json;
}

Json parameterJson(const ParameterRow& row) {
  Json json = {{"key", row.name}, {"kind", "parameter"}, {"value", valueText(row)}, {"help", row.help}};
  if (!row.unit.empty()) json["unit"] = row.unit;
  json["required"] = false;
  json["default"] = row.standard;
  if (row.kind == ParameterKind::Switch) json["default"] = row.standard != 0.0;
  if (row.kind == ParameterKind::Choice) json["default"] = row.choices.at(static_cast<std::size_t>(row.standard));
  json["changes"] = changesJson(probeField("parameters").changes);
  return json;
}

}  // namespace

std::string sceneReferenceJson() {
  Json parts = Json::array();
  for (const FieldPart& part : fieldParts()) {
    Json fields = Json::array();
    for (const FieldPart::Entry& entry : part.fields) {
      fields.push_back(fieldJson(*entry.field, entry.standard, part));
    }
    parts.push_back({{"path", part.path}, {"help", part.help}, {"fields", std::move(fields)}});
  }
  Json parameters = Json::array();
  for (const ParameterRow& row : parameterRows()) parameters.push_back(parameterJson(row));
  parts.push_back({{"path", "probes[].parameters"},
                   {"help", "Each technique reads some of them."},
                   {"fields", std::move(parameters)}});
  return parts.dump(2) + "\n";
}

}  // namespace boxprobe
