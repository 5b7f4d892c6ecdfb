#include "filters/reference/study/bench_technique.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "filters/core/base/errors.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/technique_parameters.h"

namespace boxprobe {

namespace {

using Parameters = std::map<std::string, ParameterValue>;

bool reads(const std::vector<const ParameterRow*>& rows, const std::string& name) {
  return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow* row) { return row->name == name; });
}

/// Removes parameters that have their default value.
Parameters differing(const Parameters& parameters) {
  Probe probe;
  Parameters result;
  for (const auto& [name, value] : parameters) {
    const ParameterRow* row = findParameter(name);
    probe.parameters = {{name, value}};
    if (row != nullptr && parameterNumber(probe, *row) != row->standard) result[name] = value;
  }
  return result;
}

double number(const Parameters& parameters, const std::string& name) {
  Probe probe;
  probe.parameters = parameters;
  const ParameterRow* row = findParameter(name);
  return row != nullptr ? parameterNumber(probe, *row) : 0.0;
}

/// Settings of a technique's parameters to measure, one at a time; the first is the one that a reader expects.
std::vector<Parameters> variants(const std::vector<const ParameterRow*>& rows) {
  std::vector<Parameters> all;
  if (reads(rows, "samples")) {
    const bool offset = reads(rows, "levelOffset"), filtered = reads(rows, "filtered");
    for (const double samples : {1.0, 4.0, 16.0, 64.0}) {
      Parameters plain = {{"samples", samples}};
      if (offset) plain["levelOffset"] = false;
      if (filtered) plain["filtered"] = false;
      all.push_back(plain);
      for (const char* name : {"levelOffset", "filtered"}) {
        if (!reads(rows, name)) continue;
        all.push_back(plain);
        all.back()[name] = true;
      }
    }
    // The effect of sampling patterns and distributions on the noise, one at a time.
    Parameters few = all[0];
    few["samples"] = 4.0;
    if (reads(rows, "pattern")) {
      for (const std::string_view pattern : findParameter("pattern")->choices) {
        all.push_back(few);
        all.back()["pattern"] = std::string(pattern);
      }
    }
    if (reads(rows, "sampling")) {
      all.push_back(few);
      all.back()["samples"] = 16.0;
      all.back()["sampling"] = std::string("luminance");
    }
    if (reads(rows, "blur")) {
      all.push_back(few);
      all.back()["blur"] = true;
    }
    return all;
  }
  all.push_back({});
  if (reads(rows, "budget")) {
    for (const double budget : {0.03, 0.02, 0.015}) all.push_back({{"budget", budget}});
  }
  if (reads(rows, "power")) {
    all.push_back({{"power", 2.0}});
    all.push_back({{"power", 3.0}});
  }
  return all;
}

void addRows(std::vector<BenchTechnique>& list, const Technique& technique) {
  const auto& projection = projectionRows()[static_cast<std::size_t>(technique.projection)];
  const auto& evaluation = evaluationRows()[static_cast<std::size_t>(technique.evaluation)];
  for (const Parameters& parameters : variants(parametersOf(technique))) {
    const bool filters = reads(parametersOf(technique), "filtered") && number(parameters, "filtered") != 0.0;
    const BenchTechnique row{techniqueId(technique), differing(parameters),
                             projection.ours || evaluation.ours || filters};
    if (std::find(list.begin(), list.end(), row) == list.end()) list.push_back(row);
  }
}

std::string valueText(const ParameterValue& value) {
  if (const double* n = std::get_if<double>(&value)) return numberText(*n);
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
  return std::get<std::string>(value);
}

ParameterValue parsedValue(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  char* end = nullptr;
  const double n = std::strtod(text.c_str(), &end);
  if (end != text.c_str() && *end == '\0') return n;
  return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

BenchTechnique withParameters(const Technique& technique, const std::vector<std::string>& parts,
                              const std::string& word) {
  Parameters parameters;
  const auto rows = parametersOf(technique);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto equals = parts[i].find('=');
    const std::string name = parts[i].substr(0, equals);
    const ParameterValue value = parsedValue(equals == std::string::npos ? "" : parts[i].substr(equals + 1));
    std::string problem = parameterProblem(name, value);
    if (problem.empty() && !reads(rows, name)) problem = "is not a parameter of " + techniqueId(technique);
    if (!problem.empty()) throw InputError("--techniques " + word + ": " + name + " " + problem);
    parameters[name] = value;
  }
  const bool filters = reads(rows, "filtered") && number(parameters, "filtered") != 0.0;
  const bool ours = projectionRows()[static_cast<std::size_t>(technique.projection)].ours ||
                    evaluationRows()[static_cast<std::size_t>(technique.evaluation)].ours || filters;
  return {techniqueId(technique), differing(parameters), ours};
}

}  // namespace

std::string BenchTechnique::label() const {
  const auto technique = parseTechnique(id);
  std::string text = technique ? shortTechniqueId(*technique) : id;
  const bool samples = technique && reads(parametersOf(*technique), "samples");
  if (samples) text += " " + numberText(number(parameters, "samples"));
  for (const auto& [name, value] : parameters) {
    if (name == "samples") continue;
    const bool* on = std::get_if<bool>(&value);
    text += " " + (on != nullptr ? (*on ? name : "not " + name) : name + " " + valueText(value));
  }
  return text;
}

bool BenchTechnique::sampled() const {
  const auto technique = parseTechnique(id);
  return technique && reads(parametersOf(*technique), "samples");
}

std::vector<BenchTechnique> allBenchTechniques() {
  std::vector<BenchTechnique> list;
  const int box = parseTechnique(kCostBaseline)->projection, plain = parseTechnique(kCostBaseline)->evaluation;
  for (std::size_t p = 0; p < projectionRows().size(); ++p) {
    if (static_cast<int>(p) != box) addRows(list, {static_cast<int>(p), plain});
  }
  for (std::size_t e = 0; e < evaluationRows().size(); ++e) addRows(list, {box, static_cast<int>(e)});
  // A refined hit gains more only with an evaluation that is itself close to the reference.
  for (const char* id : {"impostor+footprint8"}) {
    if (const auto technique = parseTechnique(id)) addRows(list, *technique);
  }
  return list;
}

std::vector<BenchTechnique> chooseBenchTechniques(const std::string& list) {
  const std::vector<BenchTechnique> all = allBenchTechniques();
  if (list.empty()) return all;
  std::vector<BenchTechnique> chosen;
  const auto add = [&](const BenchTechnique& technique) {
    if (std::find(chosen.begin(), chosen.end(), technique) == chosen.end()) chosen.push_back(technique);
  };
  for (const std::string& word : split(list, ',')) {
    const std::vector<std::string> parts = split(word, ':');
    const auto technique = parts.empty() ? std::nullopt : parseTechnique(parts[0]);
    if (!technique) {
      throw InputError("--techniques " + word + ": no such technique; there are: " + techniqueIdList());
    }
    if (parts.size() > 1) {
      add(withParameters(*technique, parts, word));
      continue;
    }
    std::vector<BenchTechnique> rows;
    addRows(rows, *technique);
    for (const BenchTechnique& row : rows) add(row);
  }
  for (const char* baseline : {kErrorBaseline, kCostBaseline})
    add(withParameters(*parseTechnique(baseline), {}, baseline));
  return chosen;
}

}  // namespace boxprobe
