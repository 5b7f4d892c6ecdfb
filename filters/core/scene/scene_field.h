// A field of the scene file as data: what one row says of it. Reader, writer, equality, validation, kinds of change,
// forms and the reference in data/scenes/README.md iterate the rows; scene_fields.h lists the tables, field_row.h makes
// the rows. Knows neither JSON nor Qt.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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
  Parameters,  ///< of a technique: filters/math/technique/parameter_table.h has their rows
  Box,
  BlendDistance,
  Bevel,
  Occlusion,  ///< parts with rows of their own
  ClearTo,
  Parts,  ///< lists and maps of parts that have rows of their own; the reader and the writer go through them
};

/// What a field holds, out of its struct. Nothing: an optional that is left out. A choice is the index of its id.
using FieldValue = std::variant<std::monostate, bool, int, float, double, std::string, glm::dvec2, glm::vec3,
                                glm::dvec3, std::vector<std::string>, Box, BlendDistance, Bevel, BoxOcclusion, Clear,
                                std::map<std::string, ParameterValue>>;

/// Shaders compute in single precision, which ends at 3.4e38: up to here, in scene units or units of light, the square
/// of a distance, the product of two lights and the extent of a box are finite.
constexpr double kLargestNumber = 1e18;

struct FieldRange {
  double lowest = -kLargestNumber;
  double highest = kLargestNumber;
  bool aboveLowest = false;   ///< `lowest` itself is excluded
  bool belowHighest = false;  ///< `highest` itself is excluded
};

struct FieldChoice {
  std::string_view id;
  std::string_view help = {};  ///< no sentence of its own: it follows the id
};

/// A row, but for the access to its member.
struct FieldInfo {
  std::string_view key;   ///< in the file
  std::string_view unit;  ///< behind the number; "" if it has none
  std::string_view help;  ///< one line
  FieldKind kind = FieldKind::Parts;
  bool singlePrecision = false;
  FieldRange range;                      ///< of numbers, or of each component: what a scene may hold
  std::optional<FieldRange> usual;       ///< what a form offers; left out: the range
  std::vector<int> values;               ///< of an integer: all there are
  bool powerOfTwo = false;               ///< says what `values` are
  std::vector<FieldChoice> choices;      ///< in the order of the enumerators
  std::vector<bool Changes::*> changes;  ///< empty: those of the field that the part stands in
  /// What to add where the key is missing ("add \"file\": ..."); empty: it may be left out.
  std::string_view required;
  std::string_view ifEmpty;     ///< of a text that must not be empty: what to do ("name a model file")
  std::string_view written;     ///< for the reference, where the kind does not say it: "list of objects"
  std::string_view ifLeftOut;   ///< of an optional: what counts then
  bool alwaysWritten = false;   ///< even where it equals its default
  unsigned types = ~0u;         ///< of a light: bit 1 << type for each type that has the field
  std::string_view otherTypes;  ///< of a light: the key that other types have in its place
};

/// Do lights of that type have it?
inline bool hasField(LightType type, const FieldInfo& field) {
  return (field.types >> static_cast<unsigned>(type) & 1u) != 0;
}
/// The limits of a form's field.
FieldRange formRange(const FieldInfo& field);
/// "from 0 to 1", "greater than 0", "1, 4 or 16"; "" where any number up to kLargestNumber will do.
std::string rangeText(const FieldInfo& field);

}  // namespace boxprobe
