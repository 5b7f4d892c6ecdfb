// The rows and the check against them; see the header.
#include "filters/core/technique_parameters.h"

#include <cmath>

#include "filters/core/nearest_name.h"
#include "filters/core/number_text.h"

namespace boxprobe {

const std::vector<ParameterRow>& parameterRows() {
  using Kind = ParameterKind;
  static const std::vector<ParameterRow> rows = {
      {"samples", Kind::WholeNumber, 1, 256, {}},
      {"pattern", Kind::Choice, 0, 0, {"white", "blue", "r2", "deterministic"}},
      {"animated", Kind::Switch, 0, 0, {}},
      {"levelOffset", Kind::Switch, 0, 0, {}},
      {"filtered", Kind::Switch, 0, 0, {}},
      {"sampling", Kind::Choice, 0, 0, {"ggx", "luminance"}},
      {"blur", Kind::Switch, 0, 0, {}},
      {"power", Kind::Number, 0, 16, {}},
      {"hardeningLength", Kind::Number, 1e-6, 1e6, {}},  // scene units; divided by, so never 0
      {"curve", Kind::Choice, 0, 0, {"own", "unity", "linear", "exact", "marmoset", "three-level"}},
      {"steps", Kind::WholeNumber, 1, 64, {}},
      {"budget", Kind::Number, 0, 1, {}},
  };
  return rows;
}

std::string parameterProblem(const std::string& name, const ParameterValue& value) {
  std::vector<std::string> names;
  for (const ParameterRow& row : parameterRows()) {
    names.emplace_back(row.name);
    if (row.name != name) continue;
    if (row.kind == ParameterKind::Switch) return std::holds_alternative<bool>(value) ? "" : "must be true or false";
    if (row.kind == ParameterKind::Choice) {
      const std::string* word = std::get_if<std::string>(&value);
      std::string list;
      for (const std::string_view choice : row.choices) {
        if (word != nullptr && *word == choice) return "";
        list += (list.empty() ? "\"" : ", \"") + std::string(choice) + "\"";
      }
      return "must be one of " + list;
    }
    const double* number = std::get_if<double>(&value);
    const bool whole = row.kind == ParameterKind::WholeNumber;
    if (number != nullptr && *number >= row.min && *number <= row.max && (!whole || std::floor(*number) == *number)) {
      return "";
    }
    return std::string("must be a ") + (whole ? "whole " : "") + "number from " + numberText(row.min) + " to " +
           numberText(row.max);
  }
  return "is not a parameter of any technique" + didYouMean(name, names) + "; the parameters are " +
         nameList(names, names.size());
}

}  // namespace boxprobe
