#include "filters/io/scene/pareto_front_file.h"

#include <nlohmann/json.hpp>

#include "filters/core/base/errors.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

std::vector<ParetoPoint> loadParetoFront(const std::string& path, const std::string& reference) {
  const std::string text = readWholeFile(path);
  std::vector<ParetoPoint> points;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    for (const auto& entry : json.at("summary")) {
      if (entry.at("reference") != reference) continue;
      ParetoPoint point;
      point.id = entry.at("technique").get<std::string>();
      point.label = entry.at("label").get<std::string>();
      point.cost = entry.at("frameCpuRatioToBox").get<double>();
      point.error = entry.at("error").get<double>();
      point.onParetoFront = entry.at("onFront").get<bool>();
      point.ours = entry.at("ours").get<bool>();
      points.push_back(point);
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(path + ": not a bench.json of this version; write it again with boxprobe bench");
  }
  return points;
}

}  // namespace boxprobe
