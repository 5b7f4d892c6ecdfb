// What techniques can be tuned by, as data: one row a parameter, whichever techniques use it (their rows name them).
// Scene files, validation, the window's panel, the shader's uniforms and the tests iterate these rows.
#pragma once

#include <string_view>
#include <vector>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

enum class ParameterKind { Number, WholeNumber, Switch, Choice };

struct ParameterRow {
  std::string_view name;   ///< in scene files, and of the field of shading::TechniqueParameters
  std::string_view label;  ///< for a form
  std::string_view unit;   ///< behind the number, "" if it has none
  std::string_view help;   ///< one line
  ParameterKind kind;
  double min, max;  ///< numbers: the range, inclusive
  double standard;  ///< what is used where the scene says nothing; of a switch 0 or 1, of a choice its index
  std::vector<std::string_view> choices;  ///< Choice only

  /// Where it goes. A number is a uniform: a new value costs nothing. A choice selects code, so it is compiled in: the
  /// first time a value is chosen a program is built, and nobody pays for what is not chosen. Both null: it is about
  /// the picture as a whole (`animated`, `blur`) or read by no technique of this version.
  float shading::TechniqueParameters::*number = nullptr;
  int shading::TechniqueParameters::*choice = nullptr;
};

const std::vector<ParameterRow>& parameterRows();
/// Null if there is none of that name.
const ParameterRow* findParameter(std::string_view name);
/// Every parameter at its default.
shading::TechniqueParameters standardParameters();

}  // namespace boxprobe
