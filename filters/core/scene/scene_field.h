// A field of the scene file as data: one row. Reader, writer, equality, validation, kinds of change, forms and the
// reference in data/scenes/README.md iterate the rows; scene_fields.h lists the tables, field_row.h builds the rows.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "filters/core/base/file_limits.h"
#include "filters/core/scene/changes.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

enum class FieldKind {
  Number,
  Integer,
  Boolean,
  Text,
  File,        ///< text; written relative to the scene's folder
  Choice,      ///< one of `choices`, by its id
  Vector,      ///< three numbers
  Direction,   ///< three numbers that are not all 0
  Color,       ///< three numbers: linear red, green, blue
  Decode,      ///< two numbers: a multiplier above 0 and an exponent of at least 0
  Names,       ///< a list of texts
  Parameters,  ///< of a technique: their rows are in filters/math/technique/parameter_table.h
  Box,
  BlendDistance,
  Bevel,
  Occlusion,  ///< parts with rows of their own
  LatticeOrNone,
  ClearTo,
  Parts,  ///< lists and maps of parts with rows of their own; the reader and the writer iterate them
};

/// The value of a field. Monostate: an optional that is left out. A choice is the index of its id.
using FieldValue = std::variant<std::monostate, bool, int, float, double, std::string, glm::dvec2, glm::vec3,
                                glm::dvec3, std::vector<std::string>, Box, BlendDistance, Bevel, BoxOcclusion,
                                ProbeLattice, Clear, std::map<std::string, ParameterValue>>;

struct FieldRange {
  double lowest = -limits::kNumber;
  double highest = limits::kNumber;
  bool aboveLowest = false;   ///< `lowest` itself is excluded
  bool belowHighest = false;  ///< `highest` itself is excluded
};

struct FieldChoice {
  std::string_view id;
  std::string_view help = {};  ///< empty: the id explains itself
};

/// A row without the access to its member.
struct FieldInfo {
  std::string_view key;   ///< in the file
  std::string_view unit;  ///< shown after the number; "" for none
  std::string_view help;  ///< one line
  FieldKind kind = FieldKind::Parts;
  bool singlePrecision = false;
  FieldRange range;                      ///< allowed values of a number, or of each component
  std::optional<FieldRange> usual;       ///< range of a form's slider; empty: `range`
  std::vector<int> values;               ///< of an integer: all allowed values
  bool powerOfTwo = false;               ///< are `values` powers of two?
  std::vector<FieldChoice> choices;      ///< in the order of the enumerators
  std::vector<bool Changes::*> changes;  ///< empty: those of the field that contains the part
  /// What to add if the key is missing ("add \"file\": ..."); empty: it may be left out.
  std::string_view required;
  std::string_view ifEmpty;     ///< of a text that must not be empty: what to do ("name a model file")
  std::string_view written;     ///< type for the reference, where the kind does not say it: "list of objects"
  std::string_view ifLeftOut;   ///< of an optional: what applies then
  bool alwaysWritten = false;   ///< even where it equals its default
  unsigned types = ~0u;         ///< of a light: bit 1 << type for each type that has the field
  std::string_view otherTypes;  ///< of a light: the key that other types use instead
};

/// Do lights of that type have the field?
inline bool hasField(LightType type, const FieldInfo& field) {
  return (field.types >> static_cast<unsigned>(type) & 1u) != 0;
}
/// The limits of the field in a form.
FieldRange formRange(const FieldInfo& field);
/// "from 0 to 1", "greater than 0", "1, 4 or 16"; "" where any number up to limits::kNumber will do.
std::string rangeText(const FieldInfo& field);

}  // namespace boxprobe
