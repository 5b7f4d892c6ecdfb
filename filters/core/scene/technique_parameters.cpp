#include "filters/core/scene/technique_parameters.h"

#include <algorithm>
#include <cmath>

#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/math/technique/parameter_table.h"

namespace boxprobe {

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

double parameterNumber(const Probe& probe, const ParameterRow& row) {
  const auto found = probe.parameters.find(std::string(row.name));
  if (found == probe.parameters.end()) return row.standard;
  const ParameterValue& value = found->second;
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const bool* on = std::get_if<bool>(&value)) return *on ? 1.0 : 0.0;
  const auto choice = std::find(row.choices.begin(), row.choices.end(), std::get<std::string>(value));
  return choice == row.choices.end() ? row.standard : static_cast<double>(choice - row.choices.begin());
}

void setParameter(Probe& probe, const ParameterRow& row, double number) {
  const std::string name(row.name);
  if (number == row.standard) {
    probe.parameters.erase(name);
  } else if (row.kind == ParameterKind::Switch) {
    probe.parameters[name] = number != 0.0;
  } else if (row.kind == ParameterKind::Choice) {
    probe.parameters[name] = std::string(row.choices.at(static_cast<std::size_t>(number)));
  } else {
    probe.parameters[name] = number;
  }
}

shading::TechniqueParameters techniqueParameters(const Probe& probe) {
  shading::TechniqueParameters values = standardParameters();
  for (const ParameterRow& row : parameterRows()) {
    if (row.number != nullptr) values.*row.number = static_cast<float>(parameterNumber(probe, row));
    if (row.choice != nullptr) values.*row.choice = static_cast<int>(parameterNumber(probe, row));
  }
  return values;
}

}  // namespace boxprobe
