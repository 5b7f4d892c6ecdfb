// See lessons_command.h.
#include "app/gui/window/lessons_command.h"

#include <QBuffer>
#include <QFont>
#include <QGlyphRun>
#include <QGuiApplication>
#include <QTextLayout>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/gui/lessons/lesson_loops.h"
#include "app/gui/lessons/lesson_page.h"
#include "app/gui/lessons/lesson_sheet.h"
#include "app/gui/window/window_app.h"
#include "app/lessons/lesson_language.h"
#include "app/lessons/page_texts.h"
#include "app/lessons/page_widgets.h"
#include "app/session/display_check.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/probe_captures.h"
#include "app/session/program_name.h"
#include "app/session/progress_line.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "app/web/web_scene.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/data_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/platform/process.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

constexpr int kPictureWidth = 560, kPictureHeight = 350;
constexpr int kJpegQuality = 62;  // the sheets in data/pictures are to stay below 8 MB

struct LessonsOptions {
  std::string name;
  std::string outputPath;
  std::string folder = dataFile("lessons");
  std::string language;     ///< empty: the locale's
  std::string loopsFolder;  ///< empty: none are made
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
                               {"unreviewed", lesson.unreviewed},
                               {"title", lesson.title},
                               {"chapter", lesson.chapter},
                               {"summary", lesson.summary},
                               {"scene", lesson.scene},
                               {"steps", lesson.steps.size()},
                               {"claims", lesson.claims.size()},
                               {"exercises", lesson.exercises.size()}});
  }
  return json;
}

std::string padded(const std::string& name) {
  constexpr std::size_t kColumn = 22;
  return name + std::string(kColumn - std::min(name.size(), kColumn), ' ');
}

void printList(const LessonList& list, const std::string& folder) {
  std::string chapter, text;
  for (const Lesson& lesson : list.lessons) {
    if (lesson.chapter != chapter) text += (chapter.empty() ? "" : "\n") + lesson.chapter + "\n";
    chapter = lesson.chapter;
    std::string other = lesson.language == list.language ? "" : " (" + lesson.language + ")";
    if (!lesson.unreviewed.empty()) other += " (" + lesson.unreviewed + ")";
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
  std::string language = "en";              ///< of the page's own words
  std::vector<LessonSymbol> notation = {};  ///< for a page
};

void writeStats(const LessonsOptions& options, LessonPlayer& player) {
  if (!options.report.statsPath.empty()) {
    writeTextAtomically(options.report.statsPath, statsJson(collectStats(player.renderer(), player.window())));
  }
}

constexpr int kRoomFaceSize = 128;  // a page of lessons is to stay below 8 MB

/// The scenes of the lessons that have a room.
void addScenes(LessonPage& page, const std::vector<const Lesson*>& lessons, const PageWidgets& widgets,
               const InterruptGuard& interrupt) {
  std::set<std::string> added;
  for (const Lesson* lesson : lessons) {
    const auto& rooms = widgets.rooms;
    const bool wanted = std::find(rooms.begin(), rooms.end(), lesson->name) != rooms.end();
    if (!wanted || !added.insert(lesson->scene).second) continue;
    const LoadedScene loaded = loadScene(lesson->scene);
    CaptureWishes wishes;
    wishes.quiet = true;
    for (const Probe& probe : loaded.scene.probes) wishes.probes.push_back(probe.name);
    const CapturedProbes captured = captureProbes(loaded, wishes, interrupt);
    page.addScene(lesson->scene,
                  withinOneText(webScene(loaded.scene, loaded.models, captured.captures, kRoomFaceSize, kProgramName)));
  }
}

/// Are there glyphs for all of it, here or in a font that is taken in its place?
bool hasGlyphs(const std::string& text) {
  QTextLayout layout(QString::fromStdString(text), QFont("DejaVu Sans"));
  layout.beginLayout();
  layout.createLine();
  layout.endLayout();
  const auto runs = layout.glyphRuns();
  return std::none_of(runs.begin(), runs.end(),
                      [](const QGlyphRun& run) { return run.glyphIndexes().contains(0); });  // the box
}

/// Letters that no font here has would be drawn as boxes.
void warnOfMissingFont(const std::vector<const Lesson*>& lessons) {
  for (const Lesson* lesson : lessons) {
    if (hasGlyphs(lesson->title)) continue;
    printWarnings({"lesson " + lesson->name + ": no font here has the letters of language " + lesson->language +
                   "; install one (Noto Sans CJK for Chinese), or draw a page (-o FILE.html)"});
    return;
  }
}

/// Pictures of the loops are smaller than those of the steps: two stand side by side.
constexpr int kLoopWidth = 400, kLoopHeight = 300;

/// Where a page looks for them.
std::string loopFile(const std::string& folder, const LessonLoop& loop) {
  return (fs::path(folder) / "loops" / (loop.name + ".webm")).string();
}

void addLoops(LessonPage& page, const Lesson& lesson, const PageWidgets& widgets, const std::string& folder) {
  for (const LessonLoop& loop : widgets.loops) {
    const std::string file = loopFile(folder, loop);
    if (loop.lesson == lesson.name && fs::exists(file)) page.addLoop(loop, readWholeFile(file, kLargestLoop));
  }
}

/// Nothing for the whole picture.
std::string regionText(const PictureRegion& region) {
  if (region == PictureRegion{0.0, 0.0, 1.0, 1.0}) return {};
  std::string text;
  for (const double edge : region) text += (text.empty() ? " in [" : ", ") + numberText(edge);
  return text + "]";
}

/// Draws, writes and checks. Throws WorkError if a claim does not hold.
void produce(const std::vector<const Lesson*>& lessons, const LessonsOptions& options, const Output& output,
             const PageWidgets& widgets) {
  const InterruptGuard interrupt;
  LessonPage page(output.page ? PageTexts(options.folder, output.language) : PageTexts());
  if (output.page) addScenes(page, lessons, widgets, interrupt);
  LessonPhotographer photographer(
      kPictureWidth, kPictureHeight, [&] { return !interrupt.interrupted(); }, options.report.quiet);
  std::size_t broken = 0, claims = 0;
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  for (const Lesson* lesson : lessons) {
    interrupt.check();
    const auto plan = widgets.plans.find(lesson->name);
    const LessonPictures pictures =
        photographer.take(*lesson, plan != widgets.plans.end() ? std::optional(plan->second) : std::nullopt);
    interrupt.check();
    // With the part of the picture that each was measured in.
    std::vector<std::pair<LessonPictures::Claim, PictureRegion>> measured;
    for (std::size_t i = 0; i < pictures.claims.size(); ++i) {
      measured.emplace_back(pictures.claims[i], lesson->claims[i].condition.measure.region);
    }
    for (std::size_t i = 0; i < pictures.exercises.size(); ++i) {
      if (!pictures.exercises[i]) continue;
      measured.emplace_back(*pictures.exercises[i], lesson->exercises[i].condition->measure.region);
    }
    for (const auto& [claim, region] : measured) {
      ++claims;
      broken += claim.holds ? 0 : 1;
      report.push_back({{"lesson", lesson->name},
                        {"claim", claim.say},
                        {"measured", claim.measured},
                        {"region", region},
                        {"holds", claim.holds}});
      if (options.report.json || options.report.quiet) continue;
      printResult(padded(lesson->name) + (claim.holds ? " holds: " : " DOES NOT HOLD: ") + claim.say + "\n  " +
                  claim.measured + regionText(region) + "\n");
    }
    if (output.page) {
      addLoops(page, *lesson, widgets, options.folder);
      page.add(*lesson, pictures, widgets);
    }
    if (!output.page && !output.path.empty()) {
      const std::string path = output.sheet ? output.path : output.path + "/" + lesson->name + ".jpg";
      saveSheet(path, lessonSheet(*lesson, pictures));
    }
    std::fflush(stdout);
  }
  if (output.page) writeTextAtomically(output.path, page.text(output.notation, widgets.sources));
  writeStats(options, photographer.player());
  if (options.report.json) printDocument(validJson(report));
  if (broken > 0) {
    throw WorkError(std::to_string(broken) + " of " + std::to_string(claims) + " claims of the lessons do not hold");
  }
}

/// Of the lessons that are given. Throws InputError if they have none.
void makeLoops(const LessonList& list, const LessonsOptions& options) {
  const PageWidgets widgets = loadPageWidgets(options.folder);
  std::vector<const LessonLoop*> loops;
  for (const LessonLoop& loop : widgets.loops) {
    if (options.name.empty() || loop.lesson == options.name) loops.push_back(&loop);
  }
  if (loops.empty()) throw InputError("--loops: page.json of " + options.folder + " has no loop of these lessons");
  for (const LessonLoop* loop : loops) findLesson(list, loop->lesson);
  requireLoopEncoder();
  std::error_code error;
  fs::create_directories(options.loopsFolder, error);
  if (error) throw InputError("--loops " + options.loopsFolder + ": " + error.message());
  const InterruptGuard interrupt;
  LessonPhotographer photographer(
      kLoopWidth, kLoopHeight, [&] { return !interrupt.interrupted(); }, options.report.quiet);
  for (const LessonLoop* loop : loops) {
    const std::string path = (fs::path(options.loopsFolder) / (loop->name + ".webm")).string();
    {
      ProgressLine line(loop->name, !options.report.quiet);
      const auto drawn = [&](double share) {
        interrupt.check();
        line.show(share);
      };
      encodeLoop(drawLoop(photographer, findLesson(list, loop->lesson), *loop, drawn), path);
    }
    if (!options.report.quiet && !options.report.json) {
      printResult(path + ": " + std::to_string(fs::file_size(path)) + " bytes\n");
    }
  }
  writeStats(options, photographer.player());
}

void runLessons(const LessonsOptions& options, int& argc, char** argv) {
  const LessonList list = loadLessons(options.folder, lessonLanguage(options.language, options.folder));
  warnOfBroken(list, options);
  const bool loops = !options.loopsFolder.empty();
  const bool draws = options.check || loops || !options.outputPath.empty();
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
  if (loops && (options.check || !options.outputPath.empty())) {
    throw InputError("--loops makes loops alone; leave out --check and -o, or run them by themselves");
  }
  Output output(options);
  output.notation = list.notation;
  output.language = list.language;
  const PageWidgets widgets = output.page ? loadPageWidgets(options.folder) : PageWidgets();
  if (!options.report.quiet) printWarnings(unmatchedWidgets(widgets, list.lessons));
  // Qt is here for its fonts: it needs no display, and what it remarks on its surroundings is not the user's business.
  setEnvironment("QT_QPA_PLATFORM", "offscreen", true);
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& line) {
    if (type == QtCriticalMsg || type == QtFatalMsg) printError(line.toStdString());
  });
  const QGuiApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // Qt has taken the user's
  if (!options.report.quiet) warnOfNoFonts();
  if (loops) return makeLoops(list, options);
  if (!output.page && !output.path.empty() && !options.report.quiet) warnOfMissingFont(lessons);
  produce(lessons, options, output, widgets);
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
  command
      ->add_option("--loops", options->loopsFolder,
                   "Make the short films that page.json names, as WebM files in this folder; needs ffmpeg")
      ->type_name("DIR");
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
