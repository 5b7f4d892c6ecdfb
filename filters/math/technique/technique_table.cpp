// Technique ids: parsing and printing. The rows themselves stand in shared_math.cpp, beside the functions they name.
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

template <typename Rows>
std::optional<int> rowOf(const Rows& rows, std::string_view id) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].id == id) return static_cast<int>(i);
  }
  return std::nullopt;
}

constexpr std::string_view kDefaultProjection = "box";
constexpr std::string_view kUnprojected = "infinite";
constexpr std::string_view kAutomatic = "auto";
constexpr std::string_view kDefaultEvaluation = "none";

}  // namespace

std::optional<Technique> parseTechnique(std::string_view id) {
  std::string_view projection = id;
  std::string_view evaluation = kDefaultEvaluation;
  if (const auto plus = id.find('+'); plus != std::string_view::npos) {
    projection = id.substr(0, plus);
    evaluation = id.substr(plus + 1);
  } else if (rowOf(evaluationRows(), id)) {
    projection = kDefaultProjection;
    evaluation = id;
  }
  const auto p = rowOf(projectionRows(), projection);
  const auto e = rowOf(evaluationRows(), evaluation);
  if (!p || !e) return std::nullopt;
  // It was measured with box projection, and applies to that alone.
  if (evaluation == kAutomatic && projection != kDefaultProjection) return std::nullopt;
  return Technique{*p, *e};
}

Technique withoutProjection(Technique technique) {
  technique.projection = *rowOf(projectionRows(), kUnprojected);
  if (evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id == kAutomatic) {
    technique.evaluation = *rowOf(evaluationRows(), kDefaultEvaluation);
  }
  return technique;
}

bool looksUpPieces(Technique technique) {
  const std::string_view projection = projectionRows()[static_cast<std::size_t>(technique.projection)].id;
  const std::string_view evaluation = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id;
  return (projection == "box" || projection == "impostor") &&
         (evaluation == "raytraced" || evaluation.substr(0, 9) == "footprint");
}

Technique standInFor(Technique technique) {
  const std::string_view id = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].standIn;
  if (!id.empty()) technique.evaluation = *rowOf(evaluationRows(), id);
  return technique;
}

std::vector<const ParameterRow*> parametersOf(Technique technique) {
  std::vector<const ParameterRow*> rows;
  for (const std::string_view name : projectionRows()[static_cast<std::size_t>(technique.projection)].parameters) {
    rows.push_back(findParameter(name));
  }
  for (const std::string_view name : evaluationRows()[static_cast<std::size_t>(technique.evaluation)].parameters) {
    rows.push_back(findParameter(name));
  }
  return rows;
}

bool chooses(Technique technique, const shading::TechniqueParameters& values, std::string_view parameter,
             std::string_view choice) {
  for (const ParameterRow* row : parametersOf(technique)) {
    if (row->name != parameter) continue;
    const auto at = static_cast<std::size_t>(values.*row->choice);  // refined pictures use a pattern beyond the list
    return at < row->choices.size() && row->choices[at] == choice;
  }
  return false;
}

std::string techniqueId(const Technique& technique) {
  if (evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id == kAutomatic) return std::string(kAutomatic);
  return std::string(projectionRows()[static_cast<std::size_t>(technique.projection)].id) + "+" +
         std::string(evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id);
}

std::string shortTechniqueId(const Technique& technique) {
  const std::string_view p = projectionRows()[static_cast<std::size_t>(technique.projection)].id;
  const std::string_view e = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id;
  if (e == kDefaultEvaluation) return std::string(p);
  if (p == kDefaultProjection) return std::string(e);
  return techniqueId(technique);
}

std::string techniqueIdList() {
  std::string list;
  const auto add = [&list](std::string_view id) {
    if (!list.empty()) list += ", ";
    list += id;
  };
  for (const auto& row : projectionRows()) add(row.id);
  for (const auto& row : evaluationRows()) add(row.id);
  return list;
}

}  // namespace boxprobe
