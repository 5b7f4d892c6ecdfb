// See room_task.h.
#include "app/lessons/room_task.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "filters/explain/explanation.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

namespace {

constexpr const char* kSlabFactor = "/probes/0/slabFactors/";

/// Five digits after the point: a hundredth of a millimetre in a room.
double shortened(double value) {
  return std::round(value * 1e5) / 1e5;
}

/// Nothing where the measure has no value.
std::optional<Json> rayOf(const Explanation& e) {
  if (!e.hit || e.dominant != 0) return std::nullopt;
  const ProbeExplanation& p = e.probes.front();
  if (!p.trueDistance || !p.hitDistance || p.boxDistance) return std::nullopt;  // not by the box alone
  const glm::dvec3 origin = glm::transpose(glm::dmat3(p.worldFromProbe)) * p.originWorld;
  const glm::dvec3 position = origin + glm::dvec3(p.positionProbe);
  Json ray = Json::array();
  for (int i = 0; i < 3; ++i) ray.push_back(shortened(position[i]));
  for (int i = 0; i < 3; ++i) ray.push_back(shortened(p.reflectionProbe[i]));
  ray.push_back(shortened(*p.trueDistance));
  return ray;
}

std::optional<Json> measureJson(const ShownScene& shown, const LessonMeasure& measure) {
  Json json;
  const std::string slab = kSlabFactor;
  if (measure.kind == MeasureKind::View && (measure.name == "hit-error" || measure.name == "direction-error")) {
    json["kind"] = measure.name;
  } else if (measure.kind == MeasureKind::Explain && measure.name.compare(0, slab.size(), slab) == 0 &&
             measure.name.size() == slab.size() + 1) {
    json["kind"] = "slab";
    json["axis"] = measure.name.back() - '0';
  } else {
    return std::nullopt;
  }
  json["rays"] = Json::array();
  for (const Explanation& e : explanationsOf(shown, measure)) {
    if (auto ray = rayOf(e)) json["rays"].push_back(std::move(*ray));
  }
  if (json["rays"].empty()) return std::nullopt;
  return json;
}

}  // namespace

std::string roomTask(const ShownScene& shown, const LessonTask& task, double start) {
  const auto measured = measureJson(shown, task.done.measure);
  if (!measured) return {};
  const char* const comparisons[] = {"above", "below", "within"};
  Json json = {{"done", comparisons[static_cast<int>(task.done.comparison)]},
               {"limit", task.done.limit},
               {"tolerance", task.done.tolerance},
               {"unit", task.unit},
               {"praise", task.praise},
               {"start", start},
               {"measure", *measured}};
  if (task.done.times) {
    const auto times = measureJson(shown, *task.done.times);
    if (!times) return {};
    json["times"] = *times;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxprobe
