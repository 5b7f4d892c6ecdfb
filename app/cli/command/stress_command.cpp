// See stress_command.h.
#include "app/cli/command/stress_command.h"

#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "app/cli/command/extreme_scenes.h"
#include "app/cli/report/stress_report.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/offscreen_window.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/stress/stress_subjects.h"
#include "filters/stress_gpu/stress_gpu.h"

namespace boxprobe {

namespace {

using namespace stress;

struct StressOptions {
  double count = 1.0e6;
  std::uint64_t seed = 1;
  std::string device = "cpu";
  std::vector<std::string> classes, subjects;  ///< kExtremeScenes may be among the classes
  std::string replay;
  std::uint64_t firstScene = 0;
  bool published = false;
  std::string outputPath;
  ReportOptions report;
};

const StressClass& classOf(const char* option, const std::string& id) {
  std::string known;
  for (const StressClass& c : stressClasses()) {
    if (c.id == id) return c;
    known += (known.empty() ? "" : ", ") + std::string(c.id);
  }
  known += std::string(", ") + kExtremeScenes;
  throw InputError(std::string(option) + " " + id + ": there is no such class; there are: " + known);
}

/// A technique by any of its ids, a term or a published form by its own.
const StressSubject& subjectOf(const char* option, const std::string& id) {
  const auto technique = parseTechnique(id);
  if (const StressSubject* subject = findSubject(technique ? techniqueId(*technique) : id)) return *subject;
  std::string known;
  for (const auto* subjects : {&termSubjects(), &publishedSubjects()}) {
    for (const StressSubject& s : *subjects) known += ", " + s.id;
  }
  throw InputError(std::string(option) + " " + id +
                   ": neither technique, term nor published form; there are: " + techniqueIdList() + known);
}

/// How many scenes are put together: all inputs where nothing else is asked for, else one beside 200 others and 2,000
/// at most, since one takes as long as thousands of them. None beside chosen classes, techniques or published forms,
/// nor on a card.
std::uint64_t scenesOf(const StressOptions& options) {
  const bool asked = std::find(options.classes.begin(), options.classes.end(), kExtremeScenes) != options.classes.end();
  if (asked && options.classes.size() == 1) return static_cast<std::uint64_t>(options.count);
  const bool all = options.classes.empty() && options.subjects.empty() && !options.published;
  if (!asked && (!all || options.device == "gpu")) return 0;
  return static_cast<std::uint64_t>(std::min(options.count / 200.0, 2000.0));
}

StressPlan planOf(const StressOptions& options) {
  StressPlan plan;
  plan.count = static_cast<std::uint64_t>(options.count) - scenesOf(options);
  plan.seed = options.seed;
  for (const std::string& id : options.classes) {
    if (id != kExtremeScenes) plan.classes.push_back(&classOf("--class", id));
  }
  if (options.classes.empty()) {
    for (const StressClass& c : stressClasses()) plan.classes.push_back(&c);
  }
  const auto add = [&plan](const StressSubject& s) {
    for (const StressSubject* present : plan.subjects) {
      if (present == &s) return;
    }
    plan.subjects.push_back(&s);
  };
  for (const std::string& id : options.subjects) add(subjectOf("--technique", id));
  if (options.published) {
    for (const StressSubject& s : publishedSubjects()) {
      add(s);
      add(*findSubject(s.counterpart));
    }
  }
  if (!plan.subjects.empty()) return plan;
  for (const StressSubject& s : techniqueSubjects()) add(s);
  for (const StressSubject& s : termSubjects()) add(s);
  return plan;
}

void replay(const std::string& text) {
  std::istringstream words(text);
  std::string inputs, subject, word;
  words >> inputs >> subject;
  const StressClass& c = classOf("--replay", inputs);
  const StressSubject& s = subjectOf("--replay", subject);
  std::vector<float> numbers;
  while (words >> word) {
    char* end = nullptr;
    numbers.push_back(std::strtof(word.c_str(), &end));
    if (*end != '\0') throw InputError("--replay: \"" + word + "\" is no number");
  }
  try {
    std::fputs(replayReport(c, s, inputFrom(numbers, s.parameters)).c_str(), stdout);
  } catch (const std::invalid_argument& error) {
    throw InputError("--replay " + inputs + " " + subject + ": " + error.what());
  }
}

void report(const StressOptions& options, const StressPlan& plan, const std::vector<StressCell>& cells,
            const ExtremeScenesResult& scenes) {
  std::string lines;
  for (const StressCell& cell : cells) lines += validJson(stressLine(cell, plan.seed, options.device), -1);
  if (scenes.count > 0) lines += validJson(extremeScenesLine(scenes, plan.seed), -1);
  const bool toFile = !options.outputPath.empty();
  if (toFile) {
    writeTextAtomically(options.outputPath, lines);
  } else {
    std::fputs(lines.c_str(), stdout);
  }
  if (!options.report.quiet && !options.report.json) {
    std::string table = cells.empty() ? std::string() : stressTable(cells, options.device) + publishedTable(cells);
    if (scenes.count > 0) table += extremeScenesText(scenes);
    std::fputs(table.c_str(), toFile ? stdout : stderr);
  }
}

/// Throws if an input breaks what is promised; published forms promise nothing.
void requirePromise(const StressPlan& plan, const std::vector<StressCell>& cells, const ExtremeScenesResult& scenes) {
  if (scenes.nonFinite > 0) {
    throw WorkError(std::to_string(scenes.nonFinite) + " of " + std::to_string(scenes.count) +
                    " extreme scenes give what is no number; the first is " + scenes.worst);
  }
  std::size_t broken = 0;
  const StressCell* first = nullptr;
  for (const StressCell& cell : cells) {
    if (!cell.broken()) continue;
    ++broken;
    if (first == nullptr || cell.tally.worstSeverity > first->tally.worstSeverity) first = &cell;
  }
  if (first == nullptr) return;
  throw WorkError("the promise is broken in " + std::to_string(broken) + " of " + std::to_string(cells.size()) +
                  " classes and techniques; the worst: boxprobe stress --replay '" + replayText(*first, plan.seed) +
                  "'");
}

std::vector<StressCell> results(const StressOptions& options, const StressPlan& plan, const InterruptGuard& interrupt) {
  const bool gpu = options.device == "gpu";
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  if (gpu)
    window = openOffscreenWindow(
        {"boxprobe stress --device gpu", 16, 16, 1, options.report.quiet, false, options.report.offscreen});
  ProgressLine line("inputs", !options.report.quiet);
  const auto progress = [&](double fraction) {
    line.show(fraction);
    return !interrupt.interrupted();
  };
  return gpu ? runStressGpu(window, plan, progress) : runStress(plan, progress);
}

void runStressCommand(const StressOptions& options) {
  if (!options.replay.empty()) return replay(options.replay);
  if (!options.outputPath.empty()) requireWritable("-o", options.outputPath);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const StressPlan plan = planOf(options);
  const InterruptGuard interrupt;
  std::vector<StressCell> cells;
  if (!plan.classes.empty()) cells = results(options, plan, interrupt);
  ExtremeScenesResult scenes;
  if (const std::uint64_t count = scenesOf(options); count > 0) {
    ProgressLine line("scenes", !options.report.quiet);
    scenes = runExtremeScenes(options.firstScene, count, options.seed, [&](double fraction) {
      line.show(fraction);
      return !interrupt.interrupted();
    });
  }
  interrupt.check();
  report(options, plan, cells, scenes);
  // Nothing is drawn or captured here, and the counters say so.
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(RunStats{}));
  requirePromise(plan, cells, scenes);
}

}  // namespace

Subcommand addStressCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("stress", "Stress-test techniques with adversarial inputs");
  const auto options = std::make_shared<StressOptions>();
  command->add_option("--count", options->count, "Inputs in all, spread over classes and techniques (default 1000000)")
      ->check(CLI::Range(1.0, 1.0e12))
      ->type_name("N");
  command
      ->add_option(
          "--device", options->device,
          "cpu: C++ against long double (default); gpu: the shaders against C++, whose differences are reported "
          "and held to nothing")
      ->check(CLI::IsMember({"cpu", "gpu"}))
      ->type_name("cpu|gpu");
  command->add_option("--seed", options->seed, "Other inputs; the same ones for the same seed (default 1)")
      ->type_name("S");
  command->add_option("--class", options->classes, "Only this class of inputs (repeatable; default: all)")
      ->type_name("ID")
      ->allow_extra_args(false);
  command
      ->add_option("--technique", options->subjects,
                   "Only this technique, term:NAME or published:NAME (repeatable; default: every technique and term)")
      ->type_name("ID")
      ->allow_extra_args(false);
  command->add_option("--first", options->firstScene, "Begin the class extreme-scenes with this scene (default 0)")
      ->type_name("N");
  command->add_flag("--published", options->published,
                    "The forms published elsewhere, beside what this program does instead");
  command
      ->add_option("--replay", options->replay,
                   "Say step by step what one input gives: the \"replay\" of a line that was printed")
      ->type_name("'CLASS TECHNIQUE N1 N2 ...'");
  command
      ->add_option("-o,--output", options->outputPath,
                   "Write the lines to this file and print the table alone (default: lines on stdout, table on stderr)")
      ->type_name("FILE");
  addReportOptions(*command, options->report, "Print the lines and no table");
  addOffscreenOption(*command, options->report);
  command->footer(
      "One JSON line for each class and technique. Exit status 1 if a result is no number, a lookup lies outside the\n"
      "chain, or an error exceeds its bound.\n"
      "Example:\n"
      "  boxprobe stress --count 10000000 -o stress.json\n"
      "  boxprobe stress --published --technique box -o published.json");
  return {command, [options] { runStressCommand(*options); }};
}

}  // namespace boxprobe
