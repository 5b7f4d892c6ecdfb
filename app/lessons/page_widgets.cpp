// See page_widgets.h.
#include "app/lessons/page_widgets.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/lessons/page_sketches.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

constexpr const char* kForm =
    "; expected {\"format\": \"boxprobe-lesson-page\", \"version\": 1, \"plans\": {LESSON: [x, y]}, \"rooms\": "
    "[LESSON, ..], \"figures\": {\"infinity\" or \"stand\": LESSON of \"rooms\" or [LESSON, ..], \"cone\", "
    "\"fresnel\", "
    "\"lobe\", \"glass\" or a sketch such as \"ball\": LESSON or [LESSON, ..]}, \"code\": {LESSON of \"rooms\": "
    "{\"say\": S, \"start\": [LINE, "
    "..], "
    "\"answer\": [LINE, ..]}}, \"sources\": [{\"title\": T, \"address\": \"https://..\"}, ..]}, x and y from 0 to 1";
constexpr const char* kLoopForm =
    "; expected {\"name\": N, \"lesson\": L, \"steps\": [1, ..], \"labels\": [one a step], \"say\": S, \"from\": "
    "{FIELD: NUMBERS}, \"to\": {the "
    "same}}, and \"seconds\" from 1 to 20";
constexpr std::size_t kMostLoops = 20, kMostPanels = 2;

[[noreturn]] void refuse(const std::string& path, const std::string& place) {
  throw InputError(oneLine(path + ": " + place + kForm));
}

[[noreturn]] void refuseLoop(const std::string& path, std::size_t loop, const std::string& key) {
  throw InputError(oneLine(path + ": loops[" + std::to_string(loop) + "]." + key + kLoopForm));
}

std::optional<std::vector<double>> numbersIn(const nlohmann::json& json) {
  std::vector<double> numbers;
  if (json.is_number()) return std::vector<double>{json.get<double>()};
  if (!json.is_array() || json.empty()) return std::nullopt;
  for (const auto& value : json) {
    if (!value.is_number()) return std::nullopt;
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

std::optional<Camera> cameraIn(const nlohmann::json& json) {
  if (!json.is_object() || json.size() != 3 || !json.contains("verticalFovDegrees")) return std::nullopt;
  Camera camera;
  for (const auto& [key, place] : {std::pair("position", &camera.position), std::pair("target", &camera.target)}) {
    const auto numbers = json.contains(key) ? numbersIn(json.at(key)) : std::nullopt;
    if (!numbers || numbers->size() != 3) return std::nullopt;
    *place = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }
  const auto& angle = json.at("verticalFovDegrees");
  if (!angle.is_number() || !(angle.get<double>() > 0.0 && angle.get<double>() < 180.0)) return std::nullopt;
  camera.verticalFovDegrees = angle.get<double>();
  return camera;
}

/// File names come of it.
bool isName(const nlohmann::json& json) {
  if (!json.is_string() || json.get<std::string>().empty()) return false;
  return json.get<std::string>().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

std::optional<std::string> linesIn(const nlohmann::json& json) {
  if (!json.is_array() || json.empty()) return std::nullopt;
  std::string text;
  for (const auto& line : json) {
    if (!line.is_string()) return std::nullopt;
    text += (text.empty() ? "" : "\n") + line.get<std::string>();
  }
  return text;
}

bool needsRoom(const std::string& figure) {
  return figure == "infinity" || figure == "stand";
}

bool isFigure(const std::string& name) {
  return needsRoom(name) || findPageSketch(name) != nullptr;
}

/// Nothing for what is neither a name nor names.
std::vector<std::string> namesIn(const nlohmann::json& json) {
  if (json.is_string()) return {json.get<std::string>()};
  std::vector<std::string> names;
  if (!json.is_array()) return names;
  for (const auto& name : json) {
    if (!name.is_string()) return {};
    names.push_back(name);
  }
  return names;
}

LessonLoop loopFrom(const nlohmann::json& json, const std::string& path, std::size_t index) {
  const auto refuse = [&](const std::string& key) { refuseLoop(path, index, key); };
  if (!json.is_object()) refuse("");
  for (const auto& item : json.items()) {
    const char* const known[] = {"name", "lesson", "steps", "labels", "seconds", "boxes", "say", "from", "to"};
    if (std::find(std::begin(known), std::end(known), item.key()) == std::end(known)) refuse(item.key());
  }
  const auto value = [&](const char* key) { return json.value(key, nlohmann::json()); };
  LessonLoop loop;
  if (!isName(value("name"))) refuse("name");
  loop.name = value("name");
  for (const auto& [key, text] : {std::pair("lesson", &loop.lesson), std::pair("say", &loop.say)}) {
    if (!value(key).is_string()) refuse(key);
    *text = value(key);
  }
  if (!value("steps").is_array() || value("steps").empty() || value("steps").size() > kMostPanels) refuse("steps");
  for (const auto& step : value("steps")) {
    if (!step.is_number_unsigned() || step.get<std::size_t>() < 1) refuse("steps");
    loop.steps.push_back(step.get<std::size_t>() - 1);
  }
  if (!value("labels").is_array() || value("labels").size() != loop.steps.size()) refuse("labels");
  for (const auto& text : value("labels")) {
    if (!text.is_string()) refuse("labels");
    loop.labels.push_back(text);
  }
  if (json.contains("seconds")) {
    if (!json.at("seconds").is_number()) refuse("seconds");
    loop.seconds = json.at("seconds");
  }
  if (!(loop.seconds >= 1.0 && loop.seconds <= 20.0)) refuse("seconds");
  if (json.contains("boxes") && !json.at("boxes").is_boolean()) refuse("boxes");
  loop.boxes = json.value("boxes", false);
  const nlohmann::json from = value("from"), to = value("to");
  if (!from.is_object() || from.empty()) refuse("from");
  if (!to.is_object() || to.size() != from.size()) refuse("to");
  for (const auto& [field, start] : from.items()) {
    if (!to.contains(field)) refuse("to." + field);
    if (field == "camera") {
      const auto first = cameraIn(start), second = cameraIn(to.at(field));
      if (!first || !second) refuse("from.camera");
      loop.walk = {*first, *second};
      continue;
    }
    const auto first = numbersIn(start), second = numbersIn(to.at(field));
    if (!first || !second || first->size() != second->size()) refuse("from." + field);
    loop.fields.push_back({field, *first, *second, start.is_array()});
  }
  return loop;
}

}  // namespace

std::string LessonLoop::Field::at(double t) const {
  std::string text = path + (list ? "=[" : "=");
  for (std::size_t i = 0; i < from.size(); ++i) {
    text += (i > 0 ? ", " : "") + numberText(from[i] + t * (to[i] - from[i]));
  }
  return text + (list ? "]" : "");
}

PageWidgets loadPageWidgets(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "page.json").string();
  PageWidgets widgets;
  if (!std::filesystem::exists(path)) return widgets;
  const nlohmann::json json = nlohmann::json::parse(readWholeFile(path), nullptr, false);
  if (!json.is_object()) refuse(path, "is not a JSON object");
  if (json.value("format", nlohmann::json()) != "boxprobe-lesson-page") refuse(path, "format");
  if (json.value("version", nlohmann::json()) != 1) refuse(path, "version");
  for (const auto& [key, value] : json.items()) {
    if (key == "format" || key == "version") continue;
    if (key == "plans" && value.is_object()) {
      for (const auto& [lesson, point] : value.items()) {
        const bool numbers = point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
        if (!numbers) refuse(path, "plans." + lesson);
        const PicturePoint at{point[0].get<double>(), point[1].get<double>()};
        if (!(std::min(at[0], at[1]) >= 0.0 && std::max(at[0], at[1]) <= 1.0)) refuse(path, "plans." + lesson);
        widgets.plans[lesson] = at;
      }
    } else if (key == "rooms" && value.is_array()) {
      for (const auto& lesson : value) {
        if (!lesson.is_string()) refuse(path, "rooms");
        widgets.rooms.push_back(lesson.get<std::string>());
      }
    } else if (key == "figures" && value.is_object()) {
      for (const auto& [figure, lesson] : value.items()) {
        const std::vector<std::string> names = namesIn(lesson);
        if (!isFigure(figure) || names.empty()) refuse(path, "figures." + figure);
        widgets.figures[figure] = names;
      }
    } else if (key == "code" && value.is_object()) {
      for (const auto& [lesson, code] : value.items()) {
        const auto part = [&code = code](const char* name) {
          return code.is_object() ? code.value(name, nlohmann::json()) : nlohmann::json();
        };
        const auto start = linesIn(part("start")), answer = linesIn(part("answer"));
        if (!part("say").is_string() || !start || !answer || code.size() != 3) refuse(path, "code." + lesson);
        widgets.code[lesson] = {part("say"), *start, *answer};
      }
    } else if (key == "sources" && value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const auto text = [&](const char* field) {
          const nlohmann::json found =
              value[i].is_object() ? value[i].value(field, nlohmann::json()) : nlohmann::json();
          return found.is_string() ? found.get<std::string>() : std::string();
        };
        const LessonSource source{text("title"), text("address")};
        if (source.title.empty() || source.address.rfind("https://", 0) != 0) {
          refuse(path, "sources[" + std::to_string(i) + "]");
        }
        widgets.sources.push_back(source);
      }
    } else if (key == "loops" && value.is_array() && value.size() <= kMostLoops) {
      for (std::size_t i = 0; i < value.size(); ++i) widgets.loops.push_back(loopFrom(value[i], path, i));
    } else {
      refuse(path, key);
    }
  }
  const auto hasRoom = [&](const std::string& lesson) {
    return std::find(widgets.rooms.begin(), widgets.rooms.end(), lesson) != widgets.rooms.end();
  };
  for (const auto& [figure, of] : widgets.figures) {
    if (needsRoom(figure) && !std::all_of(of.begin(), of.end(), hasRoom)) refuse(path, "figures." + figure);
  }
  for (const auto& [lesson, code] : widgets.code) {
    if (!hasRoom(lesson)) refuse(path, "code." + lesson);
  }
  return widgets;
}

std::vector<std::string> unmatchedWidgets(const PageWidgets& widgets, const std::vector<Lesson>& lessons) {
  std::vector<std::string> names = widgets.rooms, unmatched;
  for (const auto& [name, point] : widgets.plans) names.push_back(name);
  for (const LessonLoop& loop : widgets.loops) names.push_back(loop.lesson);
  for (const auto& [figure, of] : widgets.figures) names.insert(names.end(), of.begin(), of.end());
  for (const std::string& name : names) {
    const auto named = [&](const Lesson& lesson) { return lesson.name == name; };
    if (std::none_of(lessons.begin(), lessons.end(), named)) {
      unmatched.push_back("page.json: " + name + ": there is no such lesson; nothing of it is in the page");
    }
  }
  return unmatched;
}

}  // namespace boxprobe
