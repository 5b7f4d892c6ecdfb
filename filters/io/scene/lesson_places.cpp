// See lesson_places.h.
#include "filters/io/scene/lesson_places.h"

#include <set>

#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

KeyPath below(KeyPath path, const std::string& key) {
  path.push_back(key);
  return path;
}

class PlaceFinder {
 public:
  explicit PlaceFinder(const Json& lesson) : lesson_(lesson) {}

  std::vector<LessonTextPlace> find() {
    const JsonCursor root(lesson_, {});
    if (const auto language = root.find("language"))
      language->fail("belongs to a lesson that carries its texts; " + kMove);
    for (const char* name : {"title", "summary"}) always(root, {}, name);
    each(root, "steps", {}, [this](const JsonCursor& step, const KeyPath& key) { addStep(step, key); });
    each(root, "claims", {}, [this](const JsonCursor& claim, const KeyPath& key) {
      always(claim, key, "say");
      ifTrue(claim, key, "unit");
    });
    each(root, "exercises", {}, [this](const JsonCursor& exercise, const KeyPath& key) {
      for (const char* name : {"ask", "solution"}) always(exercise, key, name);
      for (const char* name : {"formula", "unit"}) ifTrue(exercise, key, name);
    });
    return std::move(places_);
  }

 private:
  inline static const std::string kMove = "move it to the file of the language's texts";

  void addStep(const JsonCursor& step, const KeyPath& key) {
    for (const char* name : {"title", "say"}) always(step, key, name);
    ifTrue(step, key, "formula");
    if (const auto mayMove = step.find("mayMove"); mayMove && mayMove->json() != true) {
      mayMove->fail("must be true, for a text of that name; " + kMove);
    }
    ifTrue(step, key, "mayMove");
    if (const auto question = step.find("question")) addQuestion(*question, below(key, "question"));
    if (const auto task = step.find("task")) {
      task->requireObject();
      for (const char* name : {"ask", "praise"}) always(*task, below(key, "task"), name);
      ifTrue(*task, below(key, "task"), "unit");
    }
    if (const auto curve = step.find("curve")) addCurve(*curve, below(key, "curve"));
  }

  void addQuestion(const JsonCursor& question, const KeyPath& key) {
    question.requireObject();
    always(question, key, "ask");
    each(question, "answers", key, [this](const JsonCursor& answer, const KeyPath& at) {
      for (const char* name : {"text", "reply"}) always(answer, at, name);
    });
  }

  void addCurve(const JsonCursor& curve, const KeyPath& key) {
    curve.requireObject();
    always(curve, key, "fieldName");
    for (const char* name : {"measure", "cost", "line"}) {
      if (curve.find(name)) always(curve, key, (std::string(name) + "Name").c_str());
    }
  }

  /// The entries of a list, each with its id.
  template <typename Add>
  void each(const JsonCursor& owner, const char* name, const KeyPath& key, const Add& add) {
    const auto list = owner.find(name);
    if (!list) return;
    std::set<std::string> taken;
    for (const JsonCursor& entry : list->elements()) {
      entry.requireObject();
      const auto id = entry.find("id");
      if (!id) entry.fail("has no id; add \"id\": \"...\", under which its texts stand");
      const std::string text = lessonTextId(*id);
      if (!taken.insert(text).second) id->fail("another one here has this id; each needs its own");
      add(entry, below(below(key, name), text));
    }
  }

  void always(const JsonCursor& entry, const KeyPath& key, const char* name) {
    if (const auto text = entry.find(name)) {
      text->fail("a lesson without a title carries no texts; " + kMove + " (or give the lesson its title)");
    }
    add(entry, key, name);
  }

  /// Values common to all languages are in the lesson; true means that this text has to be translated.
  void ifTrue(const JsonCursor& entry, const KeyPath& key, const char* name) {
    if (const auto value = entry.find(name); value && value->json() == true) add(entry, key, name);
  }

  void add(const JsonCursor& entry, const KeyPath& key, const char* name) {
    Json::json_pointer into = pointerForPath(lesson_, entry.path());
    into.push_back(name);
    places_.push_back({below(key, name), into});
  }

  const Json& lesson_;
  std::vector<LessonTextPlace> places_;
};

}  // namespace

bool carriesTexts(const Json& lesson) {
  return lesson.contains("title");
}

std::string lessonTextId(const JsonCursor& value) {
  std::string id = value.text();
  if (id.empty() || id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos) {
    value.fail("must be an id of small letters, digits and hyphens: the texts stand under it");
  }
  return id;
}

std::vector<LessonTextPlace> lessonTextPlaces(const Json& lesson) {
  return PlaceFinder(lesson).find();
}

}  // namespace boxprobe
