// See fit_report.h.
#include "app/cli/report/fit_report.h"

#include <cstdio>

namespace boxprobe {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson triple(const glm::dvec3& v) {
  return OrderedJson::array({v.x, v.y, v.z});
}

OrderedJson errorsJson(const LookupErrors& errors) {
  return {{"meanDegrees", errors.meanDegrees}, {"p95Degrees", errors.p95Degrees}};
}

const char* outcomeId(FitOutcome outcome) {
  switch (outcome) {
    case FitOutcome::Fitted:
      return "fitted";
    case FitOutcome::Open:
      return "open";
    case FitOutcome::Inside:
      return "inside";
    case FitOutcome::Kept:
      break;
  }
  return "kept";
}

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

nlohmann::ordered_json fitJson(const Probe& before, const BoxFit& fit, const std::optional<FitLightErrors>& light) {
  OrderedJson faces = OrderedJson::object();
  for (int face = 0; face < kFaces; ++face) {
    const FaceFit& each = fit.faces[static_cast<std::size_t>(face)];
    faces[faceName(face)] = {{"gainDegrees", each.gainDegrees}, {"sensitivity", each.sensitivity}, {"free", each.free}};
    if (light) faces[faceName(face)]["gainLight"] = light->faceGain[static_cast<std::size_t>(face)];
  }
  OrderedJson json = {{"name", before.name},
                      {"outcome", outcomeId(fit.outcome)},
                      {"box", {{"min", triple(fit.probe.box.min)}, {"max", triple(fit.probe.box.max)}}},
                      {"rotationDegrees", triple(fit.probe.rotationDegrees)},
                      {"origin", triple(fit.probe.origin)},
                      {"before", errorsJson(fit.before)},
                      {"after", errorsJson(fit.after)},
                      {"faces", faces},
                      {"hiddenBefore", fit.hiddenBefore},
                      {"hidden", fit.hidden},
                      {"open", fit.open},
                      {"remarks", english(fit.remarks)},
                      {"seconds", fit.seconds}};
  if (light) {
    json["before"]["lightError"] = light->before;
    json["after"]["lightError"] = light->after;
  }
  return json;
}

std::string fitText(const Probe& before, const BoxFit& fit, const std::optional<FitLightErrors>& light) {
  std::string text = before.name + ":";
  for (const Phrase& remark : fit.remarks) {
    text += (&remark == &fit.remarks.front() ? " " : "; ") + remark.english();
  }
  if (fit.remarks.empty()) text += fit.outcome == FitOutcome::Fitted ? " a better box was found" : " the box stays";
  text += "\n";
  if (fit.outcome == FitOutcome::Open || fit.outcome == FitOutcome::Inside) return text;
  text += line("  lookup error: mean %.3f -> %.3f degrees, 95 %% below %.2f -> %.2f; %.2f s\n", fit.before.meanDegrees,
               fit.after.meanDegrees, fit.before.p95Degrees, fit.after.p95Degrees, fit.seconds);
  if (light) {
    text += line("  light looked up: off by %.1f %% -> %.1f %%\n", 100.0 * light->before, 100.0 * light->after);
  }
  const glm::dvec3 &from = before.origin, &to = fit.probe.origin;
  if (from == to && fit.hidden > 0.005) {
    text += line("  the origin does not see the end of %.0f %% of the reflections\n", 100.0 * fit.hidden);
  }
  if (from != to) {
    text += line("  the origin did not see the end of %.1f %% of the reflections, now %.1f %%\n",
                 100.0 * fit.hiddenBefore, 100.0 * fit.hidden);
    text += line("  origin: (%.3f, %.3f, %.3f) -> (%.3f, %.3f, %.3f)\n", from.x, from.y, from.z, to.x, to.y, to.z);
  }
  if (before.rotationDegrees != fit.probe.rotationDegrees) {
    text += line("  turned about y: %.2f -> %.2f degrees\n", before.rotationDegrees.y, fit.probe.rotationDegrees.y);
  }
  for (int face = 0; face < kFaces; ++face) {
    const FaceFit& each = fit.faces[static_cast<std::size_t>(face)];
    const auto place = [face](const Box& box) { return (face % 2 == 0 ? box.min : box.max)[face / 2]; };
    text += line("  %s  %8.3f -> %8.3f   gain %7.3f degrees", faceName(face), place(before.box), place(fit.probe.box),
                 each.gainDegrees);
    if (light) text += line(", %5.1f %% of the light", 100.0 * light->faceGain[static_cast<std::size_t>(face)]);
    text += line("   %8.3f degrees per unit%s\n", each.sensitivity, each.free ? "   may lie anywhere" : "");
  }
  return text;
}

}  // namespace boxprobe
