// See stress_report.h.
#include "app/cli/report/stress_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace boxprobe {

using namespace stress;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kQuantile = 0.9999;
constexpr const char* kMeasureNames[kMeasures] = {"Ulp", "BoxSizes", "Relative", "Levels"};

std::string shortNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// Nine digits give a float back exactly.
std::string floatText(float value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  return text;
}

Json jsonNumber(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : (value > 0 ? "inf" : "-inf");
}

std::string padded(std::string text, std::size_t width, bool left = false) {
  const std::string fill(text.size() < width ? width - text.size() : 0, ' ');
  return left ? text + fill : fill + text;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (part == 0) return "0";
  const double share = 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(whole, 1));
  return (share < 0.01 ? "<0.01" : (share > 99.5 ? "100" : shortNumber(share))) + " %";
}

bool isPublished(const StressSubject& subject) {
  return subject.counterpart != nullptr;
}

/// Tallies of the cells that `wanted` chooses, joined by class, in the cells' order.
template <typename Wanted>
std::vector<std::pair<const StressClass*, StressTally>> byClass(const std::vector<StressCell>& cells,
                                                                const Wanted& wanted) {
  std::vector<std::pair<const StressClass*, StressTally>> rows;
  for (const StressCell& cell : cells) {
    if (rows.empty() || rows.back().first != cell.inputs) rows.push_back({cell.inputs, {}});
    if (wanted(*cell.subject)) rows.back().second.merge(cell.tally);
  }
  return rows;
}

}  // namespace

std::string replayText(const StressCell& cell, std::uint64_t seed) {
  std::string text = std::string(cell.inputs->id) + " " + cell.subject->id;
  for (const float n : numbersOf(cell.worstInput(seed), cell.subject->parameters)) text += " " + floatText(n);
  return text;
}

Json stressLine(const StressCell& cell, std::uint64_t seed, const std::string& device) {
  const StressTally& t = cell.tally;
  Json line = {{"class", cell.inputs->id}, {"technique", cell.subject->id}, {"device", device},   {"count", t.count},
               {"nonFinite", t.nonFinite}, {"badLookups", t.badLookups},    {"broken", t.broken}, {"wrong", t.wrong}};
  for (std::size_t i = 0; i < kMeasures; ++i) {
    const ErrorHistogram& e = t.errors[i];
    line[std::string("worst") + kMeasureNames[i]] = e.measured() ? jsonNumber(e.worst()) : Json();
    line[std::string("p9999") + kMeasureNames[i]] = e.measured() ? jsonNumber(e.quantile(kQuantile)) : Json();
  }
  if (t.count == 0) return line;
  Json input = Json::array();
  for (const float n : numbersOf(cell.worstInput(seed), cell.subject->parameters)) {
    input.push_back(jsonNumber(static_cast<double>(n)));
  }
  line["worstInput"] = input;
  line["replay"] = replayText(cell, seed);
  return line;
}

std::string stressTable(const std::vector<StressCell>& cells, const std::string& device) {
  const auto row = [](const std::vector<std::string>& columns) {
    std::string text = padded(columns[0], 19, true);
    for (std::size_t i = 1; i < columns.size(); ++i) text += padded(columns[i], i == 1 ? 11 : 12);
    return text + "\n";
  };
  std::string text = row({"class", "inputs", "non-finite", "bad lookup", "broken", "t, ulp", "hit, boxes", "99.99 %",
                          "relative", "levels"});
  auto rows = byClass(cells, [](const StressSubject& s) { return !isPublished(s); });
  StressTally all;
  const auto add = [&](const std::string& name, const StressTally& t, bool held) {
    const auto errorText = [held](const ErrorHistogram& errors, double value) {
      if (!errors.measured()) return std::string("-");
      return held ? shortNumber(value) : "(" + shortNumber(value) + ")";
    };
    const ErrorHistogram& hit = t.errors[kBoxSizes];
    std::vector<std::string> columns = {name, std::to_string(t.count), std::to_string(t.nonFinite),
                                        std::to_string(t.badLookups), std::to_string(t.broken)};
    for (const Measure m : {kUlp, kBoxSizes, kRelative, kLevels}) {
      columns.push_back(errorText(t.errors[m], t.errors[m].worst()));
      if (m == kBoxSizes) columns.push_back(errorText(hit, hit.quantile(kQuantile)));
    }
    text += row(columns);
  };
  for (auto& [inputs, tally] : rows) {
    if (tally.count == 0) continue;
    const bool held = inputs->held != Held::Finite;
    add(std::string(inputs->id), tally, held);
    if (!held) tally.errors = {};
    all.merge(tally);
  }
  add("all", all, true);
  return text + (device == "gpu" ? "Differences between GPU and C++, held to no bound.\n"
                                 : "Errors in brackets are held to no bound.\n");
}

std::string publishedTable(const std::vector<StressCell>& cells) {
  std::vector<const StressSubject*> forms;
  for (const StressCell& cell : cells) {
    if (isPublished(*cell.subject) && std::find(forms.begin(), forms.end(), cell.subject) == forms.end()) {
      forms.push_back(cell.subject);
    }
  }
  std::string text;
  for (const StressSubject* form : forms) {
    const auto theirs = byClass(cells, [form](const StressSubject& s) { return &s == form; });
    const auto own = byClass(cells, [form](const StressSubject& s) { return s.id == form->counterpart; });
    // Of all that is a number when it comes in.
    StressTally sum, ownSum;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
      if (theirs[i].first->held == Held::Finite) continue;
      sum.merge(theirs[i].second);
      ownSum.merge(own[i].second);
    }
    text += form->id + ": visibly wrong " + std::to_string(sum.wrong) + " of " + std::to_string(sum.count) + " (" +
            percent(sum.wrong, sum.count) + "), of that no number " + percent(sum.nonFinite, sum.count) + "; own, " +
            form->counterpart + ": " + std::to_string(ownSum.wrong) + " of " + std::to_string(ownSum.count) + "\n";
    for (std::size_t i = 0; i < theirs.size(); ++i) {
      const StressTally& a = theirs[i].second;
      const StressTally& b = own[i].second;
      if (a.wrong == 0 && b.wrong == 0) continue;
      text += "  " + padded(std::string(theirs[i].first->id), 19, true) + padded(percent(a.wrong, a.count), 9) +
              ", of that no number" + padded(percent(a.nonFinite, a.count), 9) + "   own" +
              padded(percent(b.wrong, b.count), 9) + "\n";
    }
  }
  return text;
}

std::string replayReport(const StressClass& inputs, const StressSubject& subject, const StressInput& input) {
  std::string text = std::string(inputs.id) + ", " + subject.id + "\n";
  const std::vector<std::string> names = numberNames(subject.parameters);
  const std::vector<float> numbers = numbersOf(input, subject.parameters);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "  in   " + padded(names[i], 24, true) + floatText(numbers[i]) + "\n";
  }
  TrialLog log;
  const Trial trial = subject.run(input, inputs, &log);
  for (const TrialLog::Line& line : log.lines()) {
    text += "       " + padded(line.name, 24, true) + line.value + "\n";
    if (!line.exact.empty()) text += "       " + padded("  exact", 24, true) + line.exact + "\n";
  }
  for (std::size_t i = 0; i < kMeasures; ++i) {
    if (trial.error[i] == Trial::kNotMeasured) continue;
    text += "  off  " + padded(kMeasureNames[i], 24, true) + shortNumber(trial.error[i]) + "\n";
  }
  text += std::string("  ") + (trial.finite ? "every result is a number" : "a result is NaN or infinite") +
          (trial.lookupsUsable ? "" : "; a lookup has no direction or lies outside the chain") +
          (trial.broken ? "; the promise is broken\n" : "; the promise is kept\n");
  return text;
}

}  // namespace boxprobe
