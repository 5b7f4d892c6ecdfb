// The comparison as a table and as JSON.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "filters/core/base/number_text.h"
#include "filters/io/json/json_text.h"
#include "filters/reference/bench/bench_text.h"
#include "filters/reference/truth/truth_comparison.h"

namespace boxprobe {

namespace {

double rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::isfinite(value) ? std::round(value * scale) / scale : value;
}

Json rowJson(const TruthRow& row) {
  Json out = {{"scene", row.scene},
              {"camera", row.camera},
              {"kind", row.kind},
              {"roughness", row.roughness},
              {"technique", row.technique},
              {"reference", "truth"},
              {"meanLight", rounded(row.meanLight, 5)},
              {"relativeRmse", rounded(row.relativeRmse, 6)},
              {"noise", rounded(row.noise, 6)},
              {"lightNoise", rounded(row.lightNoise, 5)},
              {"texelCost", rounded(row.texelCost, 6)},
              {"pixels", row.pixels}};
  if (row.reference()) out["holds"] = row.holds();
  out["buckets"] = Json::array();
  for (const TruthBucket& b : row.buckets) {
    out["buckets"].push_back({{"nDotV", {b.nDotVLow, b.nDotVHigh}},
                              {"meanLight", rounded(b.meanLight, 5)},
                              {"relativeRmse", rounded(b.relativeRmse, 6)},
                              {"pixels", b.pixels}});
  }
  return out;
}

}  // namespace

std::string truthTable(const TruthIndex& index, const std::vector<TruthRow>& rows) {
  std::set<double> roughnesses;
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::map<double, const TruthRow*>> lines;
  std::vector<decltype(lines)::key_type> order;
  std::size_t widest = 9;
  for (const TruthRow& row : rows) {
    roughnesses.insert(row.roughness);
    const auto key = std::make_tuple(row.technique, row.scene, row.kind, row.camera);
    if (lines[key].empty()) order.push_back(key);
    lines[key][row.roughness] = &row;
    widest = std::max(widest, row.technique.size());
  }
  std::string text = "against " + index.renderer +
                     ": mean light, relative RMSE; of a reference, what that may be: 3 x joint noise + texels\n";
  text += formatted("%-*s %-10s %-11s %-7s", static_cast<int>(widest), "technique", "scene", "floor", "camera");
  for (const double r : roughnesses) text += formatted("| roughness %-11s", numberText(r).c_str());
  text += "\n";
  for (const auto& key : order) {
    text += formatted("%-*s %-10s %-11s %-7s", static_cast<int>(widest), std::get<0>(key).c_str(),
                      std::get<1>(key).c_str(), std::get<2>(key).c_str(), std::get<3>(key).c_str());
    for (const double r : roughnesses) {
      const auto found = lines[key].find(r);
      if (found == lines[key].end()) {
        text += formatted("| %-21s", "");
        continue;
      }
      const TruthRow& row = *found->second;
      std::string cell = formatted("%.3f %.4f", row.meanLight, row.relativeRmse);
      if (row.reference()) cell += formatted("/%.3f%s", row.largestRmse(), row.holds() ? "" : " !");
      text += formatted("| %-21s", cell.c_str());
    }
    text += "\n";
  }
  return text;
}

std::string truthJson(const TruthIndex& index, const std::vector<TruthRow>& rows, bool complete) {
  Json out = {{"renderer", index.renderer},
              {"complete", complete},
              {"pictures", {{"width", index.width}, {"height", index.height}}}};
  out["rows"] = Json::array();
  for (const TruthRow& row : rows) out["rows"].push_back(rowJson(row));
  return formatJson(out);
}

}  // namespace boxprobe
