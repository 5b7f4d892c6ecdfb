// See lesson_file.h.
#include "filters/io/scene/lesson_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/lesson_json.h"
#include "filters/io/scene/lesson_texts.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

constexpr const char* kEnding = ".lesson.json";

bool isLesson(const fs::path& path) {
  const std::string name = path.filename().string(), ending = kEnding;
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// "12-floor-mirror.lesson.json" has the name "floor-mirror"; the number determines the order.
std::string lessonName(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  if (isLesson(path)) name.resize(name.size() - std::string(kEnding).size());
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != 0 && digits != std::string::npos && name[digits] == '-' ? name.substr(digits + 1) : name;
}

/// "steps[2].camera" for the path steps, 2, camera, where steps is an array.
std::string place(const JsonText& json, const KeyPath& path) {
  return json.placeText(pointerForPath(json.root, path));
}

/// Checks that every step can run: its changes apply and its camera exists.
void requireSteps(const Lesson& lesson) {
  if (lesson.steps.size() > limits::kLessonSteps) {
    throw FieldError({"steps"}, "has " + std::to_string(lesson.steps.size()) + " entries; at most " +
                                    std::to_string(limits::kLessonSteps) + " are read");
  }
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const KeyPath step = {"steps", "[" + std::to_string(i) + "]"};
    KeyPath at = step;
    try {
      at.emplace_back("scene");
      if (!lesson.steps[i].scene.empty()) loadSceneFile(lesson.steps[i].scene);
      at.back() = "set";
      Scene scene = lessonScene(lesson, i);
      at.back() = "camera";
      lessonCamera(lesson, i, scene);
      if (lesson.steps[i].curve) {
        at.back() = "curve";
        for (const double value : lesson.steps[i].curve->values) {
          Scene changed = scene;
          setSceneFields(changed, {lesson.steps[i].curve->field + "=" + numberText(value)});
        }
      }
      if (!lesson.steps[i].task) continue;
      at.back() = "task";
      for (const auto* assignments : {&lesson.steps[i].task->solution, &lesson.steps[i].task->mistake}) {
        Scene changed = scene;
        setSceneFields(changed, *assignments);
      }
    } catch (const InputError& error) {
      throw FieldError(at, error.what());
    }
  }
}

/// `texts`: those of the lesson's folder, read when the first lesson needs them.
Lesson readLesson(const std::string& path, std::optional<LessonTexts>& texts) {
  const JsonText json = parseJsonText(readWholeFile(path, limits::kLessonBytes), path);
  try {
    requireLessonHeader(json.root);
    const fs::path parent = fs::path(path).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string(), name = lessonName(path);
    if (!carriesTexts(json.root) && !texts) texts.emplace(folder, "en");
    Lesson lesson =
        lessonFromJson(carriesTexts(json.root) ? json.root : texts->lessonWithTexts(json.root, name), folder);
    lesson.path = path;
    lesson.name = name;
    try {
      loadSceneFile(lesson.scene);
    } catch (const InputError& error) {
      throw FieldError({"scene"}, error.what());
    }
    requireSteps(lesson);
    return lesson;
  } catch (const FieldError& error) {
    throw InputError(place(json, error.path()) + ": " + error.what());
  }
}

/// Throws for a language that has neither a text file nor a lesson of its own.
void requireLanguage(const LessonList& list, const LessonTexts& texts, const std::string& folder) {
  const auto isOfIt = [&](const Lesson& lesson) { return lesson.language == list.language; };
  if (list.language == "en" || texts.has(list.language)) return;
  if (std::any_of(list.lessons.begin(), list.lessons.end(), isOfIt)) return;
  const std::vector<std::string> languages = lessonLanguages(folder);
  const std::string guess = didYouMean(list.language, languages);
  throw InputError("language " + oneLine(list.language) + ": no lesson is in it" +
                   (guess.empty() ? "; there are lessons in " + nameList(languages) : guess));
}

}  // namespace

Lesson loadLessonFile(const std::string& path) {
  std::optional<LessonTexts> texts;
  return readLesson(path, texts);
}

LessonList loadLessons(const std::string& folder, const std::string& language) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(folder + ": no such folder of lessons");
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (isLesson(entry.path())) paths.push_back(entry.path().string());
  }
  if (paths.size() > limits::kLessons) {
    throw InputError(folder + ": has " + std::to_string(paths.size()) + " lessons; at most " +
                     std::to_string(limits::kLessons) + " are read");
  }
  if (paths.empty()) throw InputError(folder + ": no lesson is in it; lessons are files named NAME" + kEnding);
  std::sort(paths.begin(), paths.end());
  std::optional<LessonTexts> texts(std::in_place, folder, language);
  LessonList list;
  list.language = language;
  for (const std::string& path : paths) {
    try {
      list.lessons.push_back(readLesson(path, texts));
    } catch (const InputError& broken) {
      list.errors.emplace_back(broken.what());
    }
  }
  requireLanguage(list, *texts, folder);
  list.textErrors = texts->faults();
  list.notation = texts->notation();
  // An unreadable lesson may be the one that uses them.
  if (list.errors.empty()) {
    for (const std::string& stray : texts->strays()) list.textErrors.push_back(stray);
  }
  return list;
}

std::vector<std::string> lessonLanguages(const std::string& folder) {
  std::vector<std::string> languages = lessonTextLanguages(folder);
  if (std::find(languages.begin(), languages.end(), "en") == languages.end()) languages.emplace_back("en");
  std::sort(languages.begin(), languages.end());
  return languages;
}

const Lesson& findLesson(const LessonList& list, std::string_view name) {
  std::vector<std::string> names;
  for (const Lesson& lesson : list.lessons) {
    if (lesson.name == name) return lesson;
    names.push_back(lesson.name);
  }
  for (const Lesson& lesson : list.lessons) {
    if (formerStep(lesson, name)) return lesson;
  }
  const std::string wanted(name);
  const std::string guess = didYouMean(wanted, names);
  throw InputError("lesson " + wanted + ": there is no such lesson" +
                   (guess.empty() ? "; `boxprobe lessons` lists them" : guess));
}

std::optional<std::size_t> formerStep(const Lesson& lesson, std::string_view name) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (!name.empty() && lesson.steps[i].formerly == name) return i;
  }
  return std::nullopt;
}

namespace {

/// The last step up to `step` that starts anew; 0 if none does.
std::size_t startOf(const Lesson& lesson, std::size_t step) {
  while (step > 0 && lesson.steps[step].scene.empty()) --step;
  return step;
}

}  // namespace

const std::string& sceneFileOf(const Lesson& lesson, std::size_t step) {
  const std::string& own = lesson.steps[startOf(lesson, step)].scene;
  return own.empty() ? lesson.scene : own;
}

Scene lessonScene(const Lesson& lesson, std::size_t step) {
  Scene scene = loadSceneFile(sceneFileOf(lesson, step));
  const std::size_t start = startOf(lesson, step);
  std::vector<std::string> assignments;
  if (lesson.steps[start].scene.empty()) assignments = lesson.assignments;
  for (std::size_t i = start; i <= step; ++i) {
    const auto& own = lesson.steps[i].assignments;
    assignments.insert(assignments.end(), own.begin(), own.end());
  }
  setSceneFields(scene, assignments);
  return scene;
}

Camera lessonCamera(const Lesson& lesson, std::size_t step, const Scene& scene) {
  const std::size_t start = startOf(lesson, step);
  for (std::size_t i = step + 1; i-- > start;) {
    const LessonStep& candidate = lesson.steps[i];
    if (candidate.camera) return *candidate.camera;
    if (candidate.cameraName.empty()) continue;
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) {
      if (camera.name == candidate.cameraName) return camera;
      names.push_back(camera.name);
    }
    throw InputError("\"" + candidate.cameraName + "\": the scene has no such camera; it has " + nameList(names));
  }
  for (const Camera& camera : scene.cameras) {
    if (camera.name == "main") return camera;
  }
  return scene.cameras.empty() ? Camera() : scene.cameras.front();
}

}  // namespace boxprobe
