// The parameters a technique may be given in a scene file, as data: name, kind and choices. Read by validation (core)
// and by whoever shows them; knows nothing of what a technique does with them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene.h"

namespace boxprobe {

enum class ParameterKind { Number, WholeNumber, Switch, Choice };

struct ParameterRow {
  std::string_view name;
  ParameterKind kind;
  double min, max;                        ///< numbers: the range, inclusive
  std::vector<std::string_view> choices;  ///< Choice only
};

const std::vector<ParameterRow>& parameterRows();

/// Empty if `value` suits the parameter of that name; else what is wrong, as a phrase to follow the key path.
std::string parameterProblem(const std::string& name, const ParameterValue& value);

}  // namespace boxprobe
