// A row of the scene's fields with access to its member, and the functions that build rows. For the tables (*_rows.cpp)
// and for code that iterates them; scene_field.h describes what a row holds.
#pragma once

#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

#include "filters/core/base/file_limits.h"
#include "filters/core/scene/scene_field.h"

namespace boxprobe {

namespace field_detail {

template <typename Value, typename Variant>
struct IsAlternative;
template <typename Value, typename... Alternatives>
struct IsAlternative<Value, std::variant<Alternatives...>>
    : std::bool_constant<(std::is_same_v<Value, Alternatives> || ...)> {};

template <typename Value>
struct Unwrapped {
  using Type = Value;
};
template <typename Value>
struct Unwrapped<std::optional<Value>> {
  using Type = Value;
};

template <typename Member>
struct MemberOf;
template <typename P, typename V>
struct MemberOf<V P::*> {
  using Part = P;
  using Value = V;
  using Plain = typename Unwrapped<V>::Type;  ///< without std::optional
  static constexpr bool kOptional = !std::is_same_v<Value, Plain>;
  static constexpr bool kHasValue = std::is_enum_v<Plain> || IsAlternative<Plain, FieldValue>::value;
};

template <typename Plain>
FieldValue wrapped(const Plain& value) {
  if constexpr (std::is_enum_v<Plain>) {
    return FieldValue(std::in_place_type<int>, static_cast<int>(value));
  } else {
    return FieldValue(std::in_place_type<Plain>, value);
  }
}

template <auto Member>
FieldValue get(const typename MemberOf<decltype(Member)>::Part& part) {
  if constexpr (MemberOf<decltype(Member)>::kOptional) {
    return part.*Member ? wrapped(*(part.*Member)) : FieldValue();
  } else {
    return wrapped(part.*Member);
  }
}

template <auto Member>
void set(typename MemberOf<decltype(Member)>::Part& part, FieldValue value) {
  using Plain = typename MemberOf<decltype(Member)>::Plain;
  if constexpr (std::is_enum_v<Plain>) {
    part.*Member = static_cast<Plain>(std::get<int>(value));
  } else {
    part.*Member = std::get<Plain>(std::move(value));
  }
}

template <auto Member>
bool equal(const typename MemberOf<decltype(Member)>::Part& a, const typename MemberOf<decltype(Member)>::Part& b) {
  return a.*Member == b.*Member;
}

template <typename Plain>
constexpr FieldKind kindOf() {
  if constexpr (std::is_enum_v<Plain>) return FieldKind::Choice;
  if constexpr (std::is_floating_point_v<Plain>) return FieldKind::Number;
  if constexpr (std::is_same_v<Plain, bool>) return FieldKind::Boolean;
  if constexpr (std::is_same_v<Plain, int>) return FieldKind::Integer;
  if constexpr (std::is_same_v<Plain, std::string>) return FieldKind::Text;
  if constexpr (std::is_same_v<Plain, glm::dvec3>) return FieldKind::Vector;
  if constexpr (std::is_same_v<Plain, glm::vec3>) return FieldKind::Color;
  if constexpr (std::is_same_v<Plain, glm::dvec2>) return FieldKind::Decode;
  if constexpr (std::is_same_v<Plain, std::vector<std::string>>) return FieldKind::Names;
  if constexpr (std::is_same_v<Plain, Box>) return FieldKind::Box;
  if constexpr (std::is_same_v<Plain, BlendDistance>) return FieldKind::BlendDistance;
  if constexpr (std::is_same_v<Plain, Bevel>) return FieldKind::Bevel;
  if constexpr (std::is_same_v<Plain, BoxOcclusion>) return FieldKind::Occlusion;
  if constexpr (std::is_same_v<Plain, ProbeLattice>) return FieldKind::LatticeOrNone;
  if constexpr (std::is_same_v<Plain, Clear>) return FieldKind::ClearTo;
  if constexpr (std::is_same_v<Plain, std::map<std::string, ParameterValue>>) return FieldKind::Parameters;
  return FieldKind::Parts;
}

}  // namespace field_detail

/// A row of struct `Part`; the default value is that of a default-constructed Part. Calls are chained:
/// field<&Probe::nearDistance>("near", "m", "Nothing nearer ...").above(0).usually(1e-4,
/// 1e6).changing({&Changes::probeCapture}).
template <typename Part>
struct FieldRow : FieldInfo {
  FieldValue (*get)(const Part&) = nullptr;  ///< null, as is `set`, for kind Parts
  void (*set)(Part&, FieldValue) = nullptr;  ///< takes what `get` returns; throws std::bad_variant_access for others
  bool (*equal)(const Part&, const Part&) = nullptr;  ///< null: it has no member of its own

  FieldRow& within(double lowest, double highest) { return ranged({lowest, highest, false, false}); }
  FieldRow& between(double lowest, double highest) { return ranged({lowest, highest, true, true}); }  ///< both excluded
  FieldRow& atLeast(double lowest) { return ranged({lowest, limits::kNumber, false, false}); }
  FieldRow& above(double lowest) { return ranged({lowest, limits::kNumber, true, false}); }
  /// No upper limit except another field's.
  FieldRow& endless() {
    range.highest = std::numeric_limits<double>::infinity();
    return *this;
  }
  FieldRow& anyFinite() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return ranged({-kInfinity, kInfinity, false, false});
  }
  FieldRow& oneOf(const std::vector<int>& all) {
    values = all;
    return *this;
  }
  FieldRow& powersOfTwo(int lowest, int highest) {
    powerOfTwo = true;
    for (int value = lowest; value <= highest; value *= 2) values.push_back(value);
    return within(lowest, highest);
  }
  FieldRow& usually(double lowest, double highest) {
    usual = FieldRange{lowest, highest, false, false};
    return *this;
  }
  FieldRow& as(FieldKind other) {
    kind = other;
    return *this;
  }
  FieldRow& choose(const std::vector<FieldChoice>& ids) {
    choices = ids;
    return *this;
  }
  FieldRow& changing(const std::vector<bool Changes::*>& kinds) {
    changes = kinds;
    return *this;
  }
  FieldRow& require(std::string_view whatToAdd) {
    required = whatToAdd;
    alwaysWritten = true;
    return *this;
  }
  FieldRow& notEmpty(std::string_view whatToDo) {
    ifEmpty = whatToDo;
    return *this;
  }
  FieldRow& leftOut(std::string_view whatCounts) {
    ifLeftOut = whatCounts;
    return *this;
  }
  FieldRow& writtenAs(std::string_view how) {
    written = how;
    return *this;
  }
  FieldRow& always() {
    alwaysWritten = true;
    return *this;
  }
  FieldRow& ofTypes(std::initializer_list<LightType> some, std::string_view instead = {}) {
    types = 0;
    for (const LightType type : some) types |= 1u << static_cast<unsigned>(type);
    otherTypes = instead;
    return *this;
  }

 private:
  FieldRow& ranged(const FieldRange& all) {
    range = all;
    return *this;
  }
};

/// The row of a member.
template <auto Member>
auto field(std::string_view key, std::string_view unit, std::string_view help) {
  using Of = field_detail::MemberOf<decltype(Member)>;
  FieldRow<typename Of::Part> row;
  row.key = key;
  row.unit = unit;
  row.help = help;
  row.kind = field_detail::kindOf<typename Of::Plain>();
  row.singlePrecision = std::is_same_v<typename Of::Plain, float>;
  row.equal = &field_detail::equal<Member>;
  if constexpr (Of::kHasValue) {
    row.get = &field_detail::get<Member>;
    row.set = &field_detail::set<Member>;
  }
  if constexpr (std::is_same_v<typename Of::Plain, glm::vec3>) row.range.lowest = 0.0;
  return row;
}

/// A key without a member.
template <typename Part>
FieldRow<Part> keyOnly(std::string_view key, std::string_view help) {
  FieldRow<Part> row;
  row.key = key;
  row.help = help;
  return row;
}

/// Do two parts agree in every field?
template <typename Part>
bool sameFields(const std::vector<FieldRow<Part>>& rows, const Part& a, const Part& b) {
  for (const FieldRow<Part>& row : rows) {
    if (row.equal != nullptr && !row.equal(a, b)) return false;
  }
  return true;
}

}  // namespace boxprobe
