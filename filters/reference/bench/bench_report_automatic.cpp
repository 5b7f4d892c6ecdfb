// The end of report.md: what choosing by roughness saves, and the rows from which `auto` chooses.
#include <algorithm>
#include <array>
#include <limits>

#include "filters/core/base/number_text.h"
#include "filters/math/technique/parameter_table.h"
#include "filters/math/technique/technique_table.h"
#include "filters/reference/bench/bench_text.h"

namespace boxprobe {

namespace {

/// Does it choose among other techniques?
bool chooses(const BenchTechnique& technique) {
  return technique.id.find('+') == std::string::npos;
}

/// In pictures and random rooms; infinite if rooms are required but cannot measure the technique.
double worstAtARoughness(const BenchResult& result, const BenchSummary& s) {
  double worst = 0.0;
  for (const auto& [roughness, error] : s.errorByRoughness) worst = std::max(worst, error);
  bool shown = result.study.rows.empty();
  for (const StudyRow& row : result.study.rows) {
    if (row.technique != s.technique) continue;
    shown = true;
    for (const double error : row.tally.rmseByRoughness) worst = std::max(worst, error);
  }
  return shown ? worst : std::numeric_limits<double>::infinity();
}

/// Interpolated between the roughnesses of the study's points.
double studyError(const BenchResult& result, std::size_t technique, double roughness) {
  constexpr std::array<double, study::kRoughnesses> kNodes = {0.07, 0.2, 0.4, 0.6, 0.8, 1.0};
  for (const StudyRow& row : result.study.rows) {
    if (row.technique != technique) continue;
    if (roughness <= 0.0) return 0.0;  // a mirror is one lookup
    if (roughness <= kNodes[0]) return row.tally.rmseByRoughness[0];
    std::size_t i = 1;
    while (i + 1 < kNodes.size() && kNodes[i] < roughness) ++i;
    const double share = (roughness - kNodes[i - 1]) / (kNodes[i] - kNodes[i - 1]);
    return (1.0 - share) * row.tally.rmseByRoughness[i - 1] + share * row.tally.rmseByRoughness[i];
  }
  return 0.0;
}

}  // namespace

std::string benchAutomaticText(const BenchResult& result) {
  std::string text;
  const std::vector<BenchSummary> list = summaries(result, Truth::Box);
  for (const BenchSummary& s : list) {
    const BenchTechnique& t = result.techniques[s.technique];
    if (!chooses(t)) continue;
    const auto given = t.parameters.find("budget");
    const double budget =
        given != t.parameters.end() ? std::get<double>(given->second) : findParameter("budget")->standard;
    const BenchSummary* single = nullptr;
    for (const BenchSummary& other : list) {
      const BenchTechnique& o = result.techniques[other.technique];
      if (chooses(o) || (o.sampled() && o.parameters.count("blur") != 0) ||
          !(worstAtARoughness(result, other) <= budget))
        continue;
      if (single == nullptr || other.cpuRatioToBox.value < single->cpuRatioToBox.value) single = &other;
    }
    const double worst = worstAtARoughness(result, s);
    text += formatted("| %s | %.4f, %s | %.2f, %.2f |", numberText(budget).c_str(), worst,
                      worst <= budget ? "kept" : "exceeded", s.cpuRatioToBox.value, s.ownCpuRatioToBox);
    if (single == nullptr) {
      text += " none keeps it | | |\n";
    } else {
      text +=
          " " + result.techniques[single->technique].label() +
          formatted(" | %.2f, %.2f | %.2f, %.2f |\n", single->cpuRatioToBox.value, single->ownCpuRatioToBox,
                    s.cpuRatioToBox.value / single->cpuRatioToBox.value, s.ownCpuRatioToBox / single->ownCpuRatioToBox);
    }
  }
  if (text.empty()) return text;
  return "## Choosing by roughness\n\n`auto` against the cheapest single technique that keeps the same budget at every "
         "roughness, in the pictures and in the random rooms, all roughnesses in equal parts; costs of the frame and "
         "own.\n\n"
         "| budget | worst error at a roughness | cost of `auto` | cheapest single | its cost | ratio |\n"
         "|---|---|---|---|---|---|\n" +
         text + "\n";
}

// In the format of filters/math/technique/measured_techniques.cpp: techniques with default parameters that are worth
// choosing, with the larger of the errors in pictures and in random rooms at each roughness.
std::string benchMeasuredRows(const BenchResult& result) {
  std::vector<BenchSummary> list = summaries(result, Truth::Box);
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.cpuRatioToBox.value < b.cpuRatioToBox.value; });
  std::string text =
      "## Rows for `auto`\n\nOwn cost, and the larger error of the pictures and of the random rooms, at "
      "roughness";
  for (const double r : result.roughnesses) text += " " + numberText(r);
  text += ".\n\n```cpp\n";
  for (const BenchSummary& s : list) {
    const BenchTechnique& t = result.techniques[s.technique];
    const auto technique = parseTechnique(t.id);
    if (!technique || !t.parameters.empty() || t.sampled() ||
        (!t.ours && t.id != kCostBaseline && t.id != kErrorBaseline))
      continue;
    if (chooses(t) || projectionRows()[static_cast<std::size_t>(technique->projection)].distances) continue;
    text += formatted("{\"%s\", %.2f, {", shortTechniqueId(*technique).c_str(), s.ownCpuRatioToBox);
    for (std::size_t i = 0; i < result.roughnesses.size(); ++i) {
      double worst = studyError(result, s.technique, result.roughnesses[i]);
      const auto pictures = s.errorByRoughness.find(result.roughnesses[i]);
      if (pictures != s.errorByRoughness.end()) worst = std::max(worst, pictures->second);
      text += formatted(i == 0 ? "%.4f" : ", %.4f", worst);
    }
    text += "}},\n";
  }
  return text + "```\n";
}

}  // namespace boxprobe
