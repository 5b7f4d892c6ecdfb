// See lesson_file.h.
#include "filters/io/scene/lesson_file.h"

#include <algorithm>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/core/base/nearest_name.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/lesson_json.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestLesson = 1 << 20;
constexpr const char* kEnding = ".lesson.json";

bool isLesson(const fs::path& path) {
  const std::string name = path.filename().string(), ending = kEnding;
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// "12-floor-mirror.lesson.json" is "floor-mirror"; the number is its place.
std::string lessonName(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  if (isLesson(path)) name.resize(name.size() - std::string(kEnding).size());
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != 0 && digits != std::string::npos && name[digits] == '-' ? name.substr(digits + 1) : name;
}

/// Named "steps[2].camera" where JSON has steps, an array, 2, camera.
std::string place(const JsonText& json, const KeyPath& path) {
  return json.placeText(pointerForPath(json.root, path));
}

/// Every step can run: its changes apply and its camera is there.
void requireSteps(const Lesson& lesson) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const KeyPath step = {"steps", "[" + std::to_string(i) + "]"};
    KeyPath at = step;
    try {
      at.emplace_back("set");
      Scene scene = lessonScene(lesson, i);
      at.back() = "camera";
      lessonCamera(lesson, i, scene);
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

}  // namespace

Lesson loadLessonFile(const std::string& path) {
  const JsonText json = parseJsonText(readWholeFile(path, kLargestLesson), path);
  try {
    const std::string folder = fs::path(path).parent_path().string();
    Lesson lesson = lessonFromJson(json.root, folder.empty() ? "." : folder);
    lesson.path = path;
    lesson.name = lessonName(path);
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

LessonList loadLessons(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(folder + ": no such folder of lessons");
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (isLesson(entry.path())) paths.push_back(entry.path().string());
  }
  if (paths.empty()) throw InputError(folder + ": no lesson is in it; lessons are files named NAME" + kEnding);
  std::sort(paths.begin(), paths.end());
  LessonList list;
  for (const std::string& path : paths) {
    try {
      list.lessons.push_back(loadLessonFile(path));
    } catch (const InputError& broken) {
      list.errors.emplace_back(broken.what());
    }
  }
  return list;
}

const Lesson& findLesson(const LessonList& list, const std::string& name) {
  std::vector<std::string> names;
  for (const Lesson& lesson : list.lessons) {
    if (lesson.name == name) return lesson;
    names.push_back(lesson.name);
  }
  const std::string guess = didYouMean(name, names);
  throw InputError("lesson " + name + ": there is no such lesson" +
                   (guess.empty() ? "; `boxprobe lessons` lists them" : guess));
}

Scene lessonScene(const Lesson& lesson, std::size_t step) {
  Scene scene = loadSceneFile(lesson.scene);
  std::vector<std::string> assignments = lesson.assignments;
  for (std::size_t i = 0; i <= step; ++i) {
    const auto& own = lesson.steps[i].assignments;
    assignments.insert(assignments.end(), own.begin(), own.end());
  }
  setSceneFields(scene, assignments);
  return scene;
}

Camera lessonCamera(const Lesson& lesson, std::size_t step, const Scene& scene) {
  for (std::size_t i = step + 1; i-- > 0;) {
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
