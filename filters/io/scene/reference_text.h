// Describes the values of a field: shared by both forms of the scene file's reference. Internal to this folder.
#pragma once

#include "filters/core/scene/scene_fields.h"
#include "filters/math/technique/parameter_table.h"

namespace boxprobe {

/// JSON text in Markdown: `"box"`.
std::string quotedId(std::string_view id);

template <typename Item, typename Text>
std::string joined(const std::vector<Item>& items, const std::string& separator, Text text) {
  std::string list;
  for (const Item& item : items) list += (list.empty() ? "" : separator) + text(item);
  return list;
}

/// "number from 0 to 1, m".
std::string valueText(const FieldInfo& field);
std::string valueText(const ParameterRow& parameter);

/// For a light's field: the types that have it; "" for all.
std::string typeText(const FieldInfo& field);

/// The row of a kind of change.
const ChangeRow& changeRow(bool Changes::*kind);

}  // namespace boxprobe
