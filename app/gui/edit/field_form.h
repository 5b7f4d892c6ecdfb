// What a form shows of a field of the scene, from the field's row: limits, unit, tool tip. Called by the panels, which
// add what is theirs alone: labels, steps and decimals.
#pragma once

#include <QString>

#include "app/gui/widgets/value_field.h"
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

/// Limits and unit.
ValueField::Format fieldFormat(const FieldInfo& field, double step, int decimals);

/// The field's help and, where there is one to tell, its default.
QString fieldTip(const FieldInfo& field, const FieldValue& standard);
template <typename Part>
QString fieldTip(const FieldRow<Part>& field) {
  return fieldTip(field, field.get(Part()));
}

/// The help of one of a field's choices.
QString choiceTip(const FieldInfo& field, int choice);
template <typename Enumerator>
QString choiceTip(const FieldInfo& field, Enumerator choice) {
  return choiceTip(field, static_cast<int>(choice));
}

}  // namespace boxprobe
