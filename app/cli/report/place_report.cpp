// See place_report.h.
#include "app/cli/report/place_report.h"

#include <cmath>
#include <cstdio>

#include "app/cli/report/fit_report.h"

namespace boxprobe {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson vectorJson(const glm::dvec3& v) {
  return OrderedJson::array({v.x, v.y, v.z});
}

OrderedJson litErrorsJson(const LitErrors& errors) {
  return {{"meanDegrees", errors.meanDegrees},
          {"p95Degrees", errors.p95Degrees},
          {"hidden", errors.hidden},
          {"unlit", errors.unlit}};
}

template <class... Values>
std::string row(const char* format, Values... values) {
  char text[320];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

OrderedJson pictureErrorsJson(const PictureErrors& errors) {
  return {{"error", errors.error}, {"glossy", errors.glossy}, {"light", errors.light}};
}

std::string shareText(const LitErrors& errors) {
  return row("%.3f degrees (95 %% below %.2f; %.1f %% hidden, %.1f %% without a probe)", errors.meanDegrees,
             errors.p95Degrees, 100.0 * errors.hidden, 100.0 * errors.unlit);
}

/// The number to act on comes last.
std::string picturesText(const PictureCheck& pictures) {
  std::string text;
  for (const Phrase& each : pictures.sentences) text += each.english() + "\n";
  if (pictures.eyes == 0 || !(pictures.before.error > 0.0)) return text;
  const double change = 100.0 * (pictures.after.error / pictures.before.error - 1.0);
  text +=
      row("pictures of %zu eyes against the path tracer: error %.3f -> %.3f (%+.0f %%), mirrors %.3f -> %.3f, light "
          "%.2f -> %.2f of the truth; %.1f s\n",
          pictures.eyes, pictures.before.error, pictures.after.error, change, pictures.before.glossy,
          pictures.after.glossy, pictures.before.light, pictures.after.light, pictures.seconds);
  return text;
}

}  // namespace

nlohmann::ordered_json placeJson(const Placement& placement, const PictureCheck* pictures) {
  OrderedJson rooms = OrderedJson::array(), probes = OrderedJson::array(), kept = OrderedJson::array();
  for (std::size_t i = 0; i < placement.rooms.size(); ++i) {
    const PlacedRoom& room = placement.rooms[i];
    OrderedJson doorways = OrderedJson::array();
    for (const Doorway& doorway : room.doorways) {
      doorways.push_back({{"to", placement.rooms[doorway.b].name}, {"area", doorway.area}});
    }
    rooms.push_back({{"name", room.name},
                     {"middle", vectorJson(room.middleWorld)},
                     {"size", vectorJson(room.extent.size())},
                     {"yawDegrees", room.yawDegrees},
                     {"volume", room.volume},
                     {"parts", room.parts},
                     {"reflects", room.reflects},
                     {"doorways", doorways},
                     {"before", litErrorsJson(room.before)},
                     {"after", litErrorsJson(room.after)},
                     {"decisions", english(room.decisions)}});
  }
  for (const PlacedProbe& placed : placement.probes) {
    OrderedJson probe = fitJson(placed.probe, placed.fit);
    probe["room"] = placement.rooms[placed.room].name;
    probe["part"] = placed.part;
    probe["gainDegrees"] = placed.gainDegrees;
    probe["reason"] = placed.reason.english();
    probes.push_back(probe);
  }
  for (const Probe& probe : placement.kept) kept.push_back(probe.name);
  OrderedJson compared = nullptr;
  if (pictures != nullptr) {
    compared = {{"eyes", pictures->eyes},
                {"before", pictureErrorsJson(pictures->before)},
                {"after", pictureErrorsJson(pictures->after)},
                {"better", pictures->better},
                {"tried", english(pictures->sentences)},
                {"seconds", pictures->seconds}};
  }
  return {{"rooms", rooms},
          {"pictures", compared},
          {"probes", probes},
          {"kept", kept},
          {"before", litErrorsJson(placement.before)},
          {"after", litErrorsJson(placement.after)},
          {"bareBefore", placement.bareBefore},
          {"bareAfter", placement.bareAfter},
          {"remarks", english(placement.remarks)},
          {"cell", placement.cell},
          {"cells", placement.cells},
          {"roomSeconds", placement.roomSeconds},
          {"seconds", placement.seconds}};
}

std::string placeText(const Placement& placement, const PictureCheck* pictures) {
  std::string text;
  for (const Phrase& remark : placement.remarks) text += remark.english() + "\n";
  for (std::size_t i = 0; i < placement.rooms.size(); ++i) {
    const PlacedRoom& room = placement.rooms[i];
    const glm::dvec3 size = room.extent.size(), &at = room.middleWorld;
    text += row("%s: %.2f x %.2f x %.2f about (%.2f, %.2f, %.2f)", room.name.c_str(), size.x, size.y, size.z, at.x,
                at.y, at.z);
    if (std::abs(room.yawDegrees) >= 0.05) text += row(", turned by %.1f degrees", room.yawDegrees);
    for (const Doorway& doorway : room.doorways) {
      text += (&doorway == &room.doorways.front() ? ", open to " : ", ") + placement.rooms[doorway.b].name;
    }
    text += row("\n  error %.3f -> %.3f degrees", room.before.meanDegrees, room.after.meanDegrees);
    if (pictures != nullptr && i < pictures->rooms.size() && pictures->rooms[i].seen) {
      text += row("; of its pictures %.3f -> %.3f", pictures->rooms[i].before, pictures->rooms[i].after);
    }
    for (const Phrase& decision : room.decisions) text += "; " + decision.english();
    text += "\n";
    for (const PlacedProbe& placed : placement.probes) {
      if (placed.room != i) continue;
      const glm::dvec3 &origin = placed.probe.origin, box = placed.probe.box.size();
      text +=
          row("  probe \"%s\" at (%.2f, %.2f, %.2f), box %.2f x %.2f x %.2f: lookup error %.3f degrees, %.0f %% hidden",
              placed.probe.name.c_str(), origin.x, origin.y, origin.z, box.x, box.y, box.z,
              placed.fit.after.meanDegrees, 100.0 * placed.fit.hidden);
      for (const Phrase& remark : placed.fit.remarks) text += "; " + remark.english();
      text += "\n    " + placed.reason.english() + "\n";
    }
  }
  if (placement.rooms.empty()) return text;
  text += row("%zu rooms, %zu probes placed, %zu kept; %.1f s (rooms %.1f s, %zu cells of %.3f)\n",
              placement.rooms.size(), placement.probes.size(), placement.kept.size(), placement.seconds,
              placement.roomSeconds, placement.cells, placement.cell);
  text += "error with the scene's own probes: " + shareText(placement.before) + "\n";
  text += "error with these:                  " + shareText(placement.after) + "\n";
  text += row("surfaces seen from the rooms that no probe lights: %.2f %% -> %.2f %%\n", 100.0 * placement.bareBefore,
              100.0 * placement.bareAfter);
  if (pictures != nullptr) text += picturesText(*pictures);
  return text;
}

}  // namespace boxprobe
