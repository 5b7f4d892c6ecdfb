// The parameters of techniques as data: one row each, whichever techniques use it (their rows name them). Scene files,
// validation, the window's panel, the shader's uniforms and the tests iterate these rows.
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
  double standard;  ///< used where the scene says nothing; 0 or 1 for a switch, an index for a choice
  std::vector<std::string_view> choices;  ///< Choice only

  /// Where the value goes. A number is a uniform: changing it is free. A choice selects code and is compiled in: the
  /// first use of a value builds a program, and nobody pays for values that are not chosen. Both null: it concerns the
  /// picture as a whole (`animated`, `blur`), or no technique of this version reads it.
  float shading::TechniqueParameters::*number = nullptr;
  int shading::TechniqueParameters::*choice = nullptr;
};

const std::vector<ParameterRow>& parameterRows();
/// Null if there is none of that name.
const ParameterRow* findParameter(std::string_view name);
/// Every parameter at its default.
shading::TechniqueParameters standardParameters();

}  // namespace boxprobe
