// Lessons: what is accepted has steps that run in order. The scene they name lies beside them.
#include "filters/core/base/errors.h"
#include "filters/io/scene/lesson_file.h"
#include "tests/fuzz/parse_target.h"
#include "tests/fuzz/scratch_file.h"

namespace boxprobe::fuzz {

namespace {

constexpr const char* kLessonScene = R"({"format": "boxprobe-scene", "version": 1, "model": "room.glb",
  "cameras": {"main": {"position": [0, 1, 2], "target": [0, 1, 0]}},
  "probes": [{"name": "room", "origin": [0, 1, 0], "box": {"min": [-1, 0, -1], "max": [1, 2, 1]}}]})";

}  // namespace

void parseLessonText(const std::string& bytes) {
  static const ScratchFile scratch;
  static const std::string scene = scratch.write("s.boxprobe.json", kLessonScene);
  try {
    const Lesson lesson = loadLessonFile(scratch.write("a.lesson.json", bytes));
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const Scene shown = lessonScene(lesson, i);
      (void)lessonCamera(lesson, i, shown);
    }
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
  }
}

}  // namespace boxprobe::fuzz
