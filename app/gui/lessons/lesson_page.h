// All lessons on one HTML page that needs nothing beside it: a live figure first, pictures within, formulas as MathML,
// questions that answer, plans to take hold of. It is whole without scripts; those of data/web bring it to life. Called
// by `boxprobe lessons -o`; knows no scene.
#pragma once

#include <string>
#include <vector>

#include "app/gui/lessons/lesson_pictures.h"
#include "app/lessons/page_texts.h"
#include "app/lessons/page_widgets.h"
#include "filters/core/scene/lesson.h"

namespace boxprobe {

class LessonPage {
 public:
  explicit LessonPage(PageTexts say = {});

  /// A scene that lessons can be walked in (app/web/web_scene.h), as one JSON text, by the path that lessons name.
  void addScene(const std::string& path, const std::string& json);
  /// A loop of the lesson that is added next, and the bytes of its WebM file.
  void addLoop(const LessonLoop& loop, const std::string& webm);
  /// Its room, if `widgets` wants one and its scene has been added, follows the steps.
  void add(const Lesson& lesson, const LessonPictures& pictures, const PageWidgets& widgets);
  /// `notation` stands at the end, as a table; empty: none. `sources` likewise.
  std::string text(const std::vector<LessonSymbol>& notation, const std::vector<LessonSource>& sources) const;

 private:
  struct Section {
    std::string name, title, chapter, html;
    int minutes = 0;
  };
  std::vector<std::string> numbers() const;  ///< of each section: "7", or "A.1" in an appendix
  std::string contents() const;
  std::string body() const;

  PageTexts say_;
  std::vector<Section> sections_;
  std::string opening_, answers_, solutions_, loops_, sceneTexts_;
  std::vector<std::string> scenes_;  ///< their paths
};

}  // namespace boxprobe
