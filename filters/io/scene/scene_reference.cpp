// The reference as Markdown.
#include "filters/io/scene/scene_reference.h"

#include "filters/core/base/number_text.h"
#include "filters/io/scene/field_json.h"
#include "filters/io/scene/reference_text.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

std::string changeIds(const std::vector<bool Changes::*>& kinds) {
  return joined(kinds, ", ", [](bool Changes::*kind) { return std::string(changeRow(kind).id); });
}

std::string defaultText(const FieldInfo& field, const FieldValue& standard) {
  if (!field.required.empty()) return "required";
  if (!field.ifLeftOut.empty()) return std::string(field.ifLeftOut);
  return "`" + valueJson(standard, field, {}).dump() + "`";
}

std::string meaningText(const FieldInfo& field) {
  std::string text(field.help);
  if (!typeText(field).empty()) text += " Only of type " + typeText(field) + ".";
  for (const FieldChoice& choice : field.choices) {
    if (!choice.help.empty()) text += "<br>" + quotedId(choice.id) + ": " + std::string(choice.help) + ".";
  }
  return text;
}

std::string partText(const FieldPart& part) {
  bool ownChanges = false;
  for (const FieldPart::Entry& entry : part.fields) {
    ownChanges = ownChanges || (!entry.field->changes.empty() && entry.field->changes != part.changes);
  }
  std::string text =
      "### " + (part.path.empty() ? "The file" : "`" + std::string(part.path) + "`") + "\n\n" + std::string(part.help);
  if (!part.changes.empty()) text += " A change costs: " + changeIds(part.changes) + ".";
  text += "\n\n| key | value | default |" + std::string(ownChanges ? " costs |" : "") + " meaning |\n|---|---|---|" +
          (ownChanges ? "---|" : "") + "---|\n";
  for (const FieldPart::Entry& entry : part.fields) {
    const FieldInfo& field = *entry.field;
    text += "| `" + std::string(field.key) + "` | " + valueText(field) + " | " + defaultText(field, entry.standard) +
            " | " + (ownChanges ? changeIds(field.changes) + " | " : "") + meaningText(field) + " |\n";
  }
  return text + "\n";
}

std::string parameterDefault(const ParameterRow& row) {
  if (row.kind == ParameterKind::Choice) return quotedId(row.choices.at(static_cast<std::size_t>(row.standard)));
  if (row.kind == ParameterKind::Switch) return row.standard != 0.0 ? "`true`" : "`false`";
  return "`" + numberText(row.standard) + "`";
}

std::string parametersText() {
  std::string text =
      "### `probes[].parameters`\n\nEach technique reads some of them. The ids that a technique is put together "
      "from: " +
      techniqueIdList() + ".\n\n| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const ParameterRow& row : parameterRows()) {
    text += "| `" + std::string(row.name) + "` | " + valueText(row) + " | " + parameterDefault(row) + " | " +
            std::string(row.help) + " |\n";
  }
  return text + "\n";
}

}  // namespace

std::string sceneReferenceMarkdown() {
  std::string text = "What a change costs:\n\n";
  for (const ChangeRow& row : changeRows()) {
    if (!row.cost.empty()) text += "- *" + std::string(row.id) + "*: " + std::string(row.cost) + "\n";
  }
  text += "\n";
  for (const FieldPart& part : fieldParts()) text += partText(part);
  return text + parametersText();
}

}  // namespace boxprobe
