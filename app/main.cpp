// The program: reads the command line, runs a sub-command or opens the window, and turns every failure into one line on
// stderr and an exit status (1 the work failed, 2 bad usage or bad input). Knows no more of either.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command/bake_command.h"
#include "app/cli/command/bench_command.h"
#include "app/cli/command/explain_command.h"
#include "app/cli/command/export_command.h"
#include "app/cli/command/fit_command.h"
#include "app/cli/command/import_command.h"
#include "app/cli/command/info_command.h"
#include "app/cli/command/place_command.h"
#include "app/cli/command/render_command.h"
#include "app/cli/command/report_command.h"
#include "app/cli/command/short_run.h"
#include "app/cli/command/stress_command.h"
#include "app/cli/options/help_text.h"
#include "app/gui/window/lessons_command.h"
#include "app/gui/window/window_app.h"
#include "app/session/display_check.h"
#include "app/session/environment_check.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "filters/core/base/errors.h"

namespace {

using namespace boxprobe;

/// The file that a sub-command works on; its own name where none was given.
std::string inputOf(const CLI::App& arguments) {
  for (const CLI::Option* option : arguments.get_options()) {
    if (option->get_positional() && !option->results().empty()) return option->results().front();
  }
  return arguments.get_name();
}

int run(int& argc, char** argv) {
  requireMeantEnvironment();
  CLI::App program("Places reflection probes, shows what box projection does to them, and draws the result.",
                   "boxprobe");
  program.formatter(std::make_shared<HelpText>());  // the sub-commands take it over
  program.set_version_flag("--version", "boxprobe " BOXPROBE_VERSION);
  std::string scenePath;
  WindowOptions window;
  program.add_option(
      "SCENE", scenePath,
      "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp) to open in the window");
  program
      .add_option("--stats", window.statsPath,
                  "When the window closes, write counters and times of what ran to this file")
      ->type_name("FILE.json");
  addTuningOption(program);
  program.footer(
      "Examples:\n"
      "  boxprobe data/scenes/building.boxprobe.json\n"
      "  boxprobe render data/scenes/building.boxprobe.json -o building.png\n"
      "Each sub-command explains itself: boxprobe render --help");
  program.require_subcommand(0, 1);
  const std::vector<Subcommand> subcommands = {
      addRenderCommand(program), addBakeCommand(program),   addExplainCommand(program),
      addExportCommand(program), addImportCommand(program), addInfoCommand(program),
      addFitCommand(program),    addPlaceCommand(program),  addReportCommand(program),
      addBenchCommand(program),  addStressCommand(program), addLessonsCommand(program, argc, argv)};

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      program.exit(error);
      std::cout.flush();
      finishResults();
      return 0;
    }
    std::string command = "boxprobe";
    for (const Subcommand& subcommand : subcommands) {
      if (subcommand.arguments->parsed()) command += " " + subcommand.arguments->get_name();
    }
    throw InputError(std::string(error.what()) + "; see " + command + " --help");
  }
  for (const Subcommand& subcommand : subcommands) {
    if (!subcommand.arguments->parsed()) continue;
    if (!scenePath.empty()) throw InputError(scenePath + ": not expected before a sub-command; see boxprobe --help");
    if (!window.statsPath.empty()) throw InputError("--stats belongs after the sub-command; see boxprobe --help");
    const InterruptGuard interrupt;
    withMemoryFor(inputOf(*subcommand.arguments), [&] { subcommand.run(); });
    finishResults();
    if (interrupt.interrupted()) throw WorkError("interrupted; what was asked for was done by then");
    return 0;
  }
  if (!window.statsPath.empty()) requireWritable("--stats", window.statsPath);
  requireDisplay("boxprobe");
  return runWindow(argc, argv, scenePath, window);
}

}  // namespace

int main(int argc, char** argv) {
  boxprobe::answerWriteSignals();
  try {
    return boxprobe::endQuickly(run(argc, argv));
  } catch (const boxprobe::Error& error) {
    printError(error.what());
    return boxprobe::endQuickly(error.exitStatus());
  } catch (const std::exception& error) {
    printError(boxprobe::messageOf(error));
  }
  return boxprobe::endQuickly(1);
}
