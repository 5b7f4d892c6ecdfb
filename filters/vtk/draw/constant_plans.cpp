#include "filters/vtk/draw/constant_plans.h"

#include <algorithm>
#include <map>
#include <optional>

namespace boxprobe {

namespace {

/// Objects of one program with the very same numbers, by their place among the uses.
using Alike = std::vector<std::size_t>;
using AlikeGroups = std::vector<Alike>;

RestingValues sharedValues(const AlikeGroups& kinds, const std::vector<ConstantUse>& uses) {
  std::optional<RestingValues> values;
  for (const Alike& kind : kinds) {
    const RestingValues& own = uses[kind.front()].values;
    values = values ? values->sharedWith(own) : own;
  }
  return values.value_or(RestingValues());
}

struct OwnProgram {
  std::size_t program, kind;
  long gain;
};

}  // namespace

std::vector<std::shared_ptr<const RestingValues>> foldableConstants(const std::vector<ConstantUse>& uses,
                                                                    std::size_t more) {
  std::map<std::string, std::map<std::string, Alike>> found;
  for (std::size_t i = 0; i < uses.size(); ++i) found[uses[i].program][uses[i].values.key()].push_back(i);
  std::vector<AlikeGroups> programs;
  std::vector<OwnProgram> candidates;
  for (const auto& program : found) {
    AlikeGroups kinds;
    for (const auto& kind : program.second) kinds.push_back(kind.second);
    const int worth = sharedValues(kinds, uses).worth();
    for (std::size_t k = 0; k < kinds.size() && kinds.size() > 1; ++k) {
      const auto gain = static_cast<long>(kinds[k].size()) * (uses[kinds[k].front()].values.worth() - worth);
      candidates.push_back({programs.size(), k, gain});
    }
    programs.push_back(std::move(kinds));
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const OwnProgram& a, const OwnProgram& b) { return a.gain > b.gain; });
  std::vector<std::shared_ptr<const RestingValues>> plans(uses.size());
  const auto give = [&plans](const Alike& kind, const std::shared_ptr<const RestingValues>& values) {
    for (const std::size_t i : kind) plans[i] = values;
  };
  // The last kind of a program needs none of its own: it is what the others leave.
  std::vector<std::size_t> left(programs.size());
  for (std::size_t p = 0; p < programs.size(); ++p) left[p] = programs[p].size();
  for (const OwnProgram& candidate : candidates) {
    if (more == 0 || candidate.gain <= 0) break;
    if (left[candidate.program] < 2) continue;
    Alike& kind = programs[candidate.program][candidate.kind];
    give(kind, std::make_shared<RestingValues>(uses[kind.front()].values));
    kind.clear();
    --left[candidate.program];
    --more;
  }
  for (AlikeGroups& kinds : programs) {
    kinds.erase(std::remove_if(kinds.begin(), kinds.end(), [](const Alike& kind) { return kind.empty(); }),
                kinds.end());
    const auto values = std::make_shared<RestingValues>(sharedValues(kinds, uses));
    if (values->empty()) continue;
    for (const Alike& kind : kinds) give(kind, values);
  }
  return plans;
}

}  // namespace boxprobe
