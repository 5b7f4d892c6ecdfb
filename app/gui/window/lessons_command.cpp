// See lessons_command.h.
#include "app/gui/window/lessons_command.h"

#include <QBuffer>
#include <QGuiApplication>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/gui/lessons/lesson_page.h"
#include "app/gui/lessons/lesson_sheet.h"
#include "app/gui/window/window_app.h"
#include "app/lessons/lesson_language.h"
#include "app/session/display_check.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/base/nearest_name.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/lesson_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

constexpr int kPictureWidth = 560, kPictureHeight = 350;
constexpr int kJpegQuality = 90;

struct LessonsOptions {
  std::string name;
  std::string outputPath;
  std::string folder = BOXPROBE_DATA_DIR "/lessons";
  std::string language;  ///< empty: the locale's
  bool check = false;
  ReportOptions report;
};

bool isPicture(const std::string& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

void saveSheet(const std::string& path, const QImage& sheet) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const bool png = lowerExtension(path) == ".png";
  if (!sheet.save(&buffer, png ? "PNG" : "JPEG", png ? -1 : kJpegQuality)) {
    throw WorkError(path + ": the picture could not be encoded");
  }
  writeTextAtomically(path, bytes.toStdString());
}

nlohmann::ordered_json listJson(const LessonList& list) {
  nlohmann::ordered_json json = {{"language", list.language},
                                 {"lessons", nlohmann::ordered_json::array()},
                                 {"errors", list.errors},
                                 {"textErrors", list.textErrors}};
  for (const Lesson& lesson : list.lessons) {
    json["lessons"].push_back({{"name", lesson.name},
                               {"language", lesson.language},
                               {"title", lesson.title},
                               {"chapter", lesson.chapter},
                               {"summary", lesson.summary},
                               {"scene", lesson.scene},
                               {"steps", lesson.steps.size()},
                               {"claims", lesson.claims.size()}});
  }
  return json;
}

std::string padded(const std::string& name) {
  constexpr std::size_t kWidth = 22;
  return name + std::string(kWidth - std::min(name.size(), kWidth), ' ');
}

void printList(const LessonList& list, const std::string& folder) {
  std::string chapter, text;
  for (const Lesson& lesson : list.lessons) {
    if (lesson.chapter != chapter) text += (chapter.empty() ? "" : "\n") + lesson.chapter + "\n";
    chapter = lesson.chapter;
    const std::string other = lesson.language == list.language ? "" : " (" + lesson.language + ")";
    text += "  " + padded(lesson.name) + " " + lesson.title + other + "\n";
  }
  const std::vector<std::string> languages = lessonLanguages(folder);
  const std::string all = languages.size() > 1 ? " (of " + nameList(languages, languages.size()) + ")" : "";
  printResult(text + "\nLanguage: " + list.language + all + "\n");
}

/// The broken ones are told, and the rest goes on.
void warnOfBroken(const LessonList& list, const LessonsOptions& options) {
  if (options.report.quiet) return;
  printWarnings(list.errors);
  printWarnings(list.textErrors);
}

std::vector<const Lesson*> chosen(const LessonList& list, const std::string& name) {
  std::vector<const Lesson*> lessons;
  if (!name.empty()) return {&findLesson(list, name)};
  for (const Lesson& lesson : list.lessons) lessons.push_back(&lesson);
  return lessons;
}

struct Output {
  explicit Output(const LessonsOptions& options)
      : path(options.outputPath),
        page(lowerExtension(path) == ".html" || lowerExtension(path) == ".htm"),
        sheet(!page && isPicture(path)) {
    if (path.empty()) return;
    if (sheet && options.name.empty()) {
      throw InputError("-o " + path +
                       ": a picture holds one lesson; name the lesson, or give a folder for all sheets, or " +
                       "a .html file for a page of all");
    }
    if (page || sheet) {
      requireWritable("-o", path);
      return;
    }
    if (!lowerExtension(path).empty()) {
      throw InputError("-o " + path + ": give a .png or .jpg for a sheet, a .html for a page, a folder for all sheets");
    }
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw InputError("-o " + path + ": " + error.message());
  }
  std::string path;
  bool page, sheet;
};

void writeStats(const LessonsOptions& options, LessonPlayer& player) {
  if (!options.report.statsPath.empty()) {
    writeTextAtomically(options.report.statsPath, statsJson(collectStats(player.renderer(), player.window())));
  }
}

/// Draws, writes and checks. Throws WorkError if a claim does not hold.
void produce(const std::vector<const Lesson*>& lessons, const LessonsOptions& options, const Output& output) {
  const InterruptGuard interrupt;
  LessonPhotographer photographer(
      kPictureWidth, kPictureHeight, [&] { return !interrupt.interrupted(); }, options.report.quiet);
  LessonPage page;
  std::size_t broken = 0, claims = 0;
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  for (const Lesson* lesson : lessons) {
    interrupt.check();
    const LessonPictures pictures = photographer.take(*lesson);
    interrupt.check();
    for (const LessonPictures::Claim& claim : pictures.claims) {
      ++claims;
      broken += claim.holds ? 0 : 1;
      report.push_back(
          {{"lesson", lesson->name}, {"claim", claim.say}, {"measured", claim.measured}, {"holds", claim.holds}});
      if (options.report.json || options.report.quiet) continue;
      printResult(padded(lesson->name) + (claim.holds ? " holds: " : " DOES NOT HOLD: ") + claim.say + "\n  " +
                  claim.measured + "\n");
    }
    if (output.page) page.add(*lesson, pictures);
    if (!output.page && !output.path.empty()) {
      const std::string path = output.sheet ? output.path : output.path + "/" + lesson->name + ".jpg";
      saveSheet(path, lessonSheet(*lesson, pictures));
    }
    std::fflush(stdout);
  }
  if (output.page) writeTextAtomically(output.path, page.text());
  writeStats(options, photographer.player());
  if (options.report.json) printDocument(validJson(report));
  if (broken > 0) {
    throw WorkError(std::to_string(broken) + " of " + std::to_string(claims) + " claims of the lessons do not hold");
  }
}

void runLessons(const LessonsOptions& options, int& argc, char** argv) {
  const LessonList list = loadLessons(options.folder, lessonLanguage(options.language, options.folder));
  warnOfBroken(list, options);
  const bool draws = options.check || !options.outputPath.empty();
  if (options.name.empty() && !draws) {
    if (options.report.json) {
      printDocument(validJson(listJson(list)));
    } else {
      printList(list, options.folder);
    }
    return;
  }
  const std::vector<const Lesson*> lessons = chosen(list, options.name);
  if (!draws) {
    requireDisplay("boxprobe lessons");
    WindowOptions window;
    window.statsPath = options.report.statsPath;
    window.lesson = options.name;
    window.language = options.language;
    runWindow(argc, argv, {}, window);
    return;
  }
  const Output output(options);
  requireDisplay("boxprobe lessons");
  // Qt is here for its fonts; what it remarks on its surroundings is not the user's business.
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& line) {
    if (type == QtCriticalMsg || type == QtFatalMsg) printError(line.toStdString());
  });
  const QGuiApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // Qt has taken the user's
  produce(lessons, options, output);
}

}  // namespace

Subcommand addLessonsCommand(CLI::App& program, int& argc, char** argv) {
  CLI::App* command = program.add_subcommand("lessons", "List the lessons, open one, or draw them as sheets or a page");
  const auto options = std::make_shared<LessonsOptions>();
  command->add_option("NAME", options->name, "Lesson to open in the window or to draw");
  command
      ->add_option("-o,--output", options->outputPath,
                   "Draw instead of opening: a sheet (.png, .jpg) of the lesson; a page (.html) of it, or of all "
                   "without NAME; or a folder for all sheets")
      ->type_name("FILE");
  command->add_flag("--check", options->check, "Measure the lessons' claims; exit status 1 if a claim does not hold");
  command->add_option("--folder", options->folder, "Folder of the lesson files (default: the program's own)")
      ->type_name("DIR");
  command
      ->add_option("--language", options->language,
                   "Language of the lessons' texts (default: the locale's if it has a file of texts, otherwise en)")
      ->type_name("ID");
  addReportOptions(*command, options->report, "Print the list or the measured claims as JSON");
  command->footer(
      "Examples:\n"
      "  boxprobe lessons\n"
      "  boxprobe lessons floor-mirror\n"
      "  boxprobe lessons floor-mirror -o floor-mirror.png\n"
      "  boxprobe lessons -o lessons.html");
  return {command, [options, &argc, argv] { runLessons(*options, argc, argv); }};
}

}  // namespace boxprobe
