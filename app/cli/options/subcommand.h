// What every sub-command is to main: its arguments and what runs it. And the options that all of them have.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>

#include "app/session/offscreen_choice.h"

namespace boxprobe {

struct Subcommand {
  CLI::App* arguments = nullptr;  ///< owned by the program's CLI::App
  std::function<void()> run;      ///< called once, if the arguments were given; throws Error
};

struct ReportOptions {
  std::string statsPath;  ///< empty: none asked for
  bool json = false;
  bool quiet = false;
  Offscreen offscreen = Offscreen::Automatic;
};

/// `jsonHelp`: what --json of this sub-command prints.
inline void addReportOptions(CLI::App& command, ReportOptions& options, const std::string& jsonHelp) {
  command.add_option("--stats", options.statsPath, "Write counters and times to this file")->type_name("FILE.json");
  command.add_flag("--json", options.json, jsonHelp);
  command.add_flag("--quiet", options.quiet, "Print errors only: no progress, warnings or summary");
}

/// For sub-commands that draw.
inline void addOffscreenOption(CLI::App& command, ReportOptions& options) {
  static const std::map<std::string, Offscreen> choices = {
      {"auto", Offscreen::Automatic}, {"egl", Offscreen::Egl}, {"osmesa", Offscreen::Osmesa}, {"x", Offscreen::X}};
  command
      .add_option("--offscreen", options.offscreen,
                  "What to draw with: auto (an X display if DISPLAY is set, else EGL), egl, osmesa or x")
      ->transform(CLI::CheckedTransformer(choices, CLI::ignore_case).description(""))
      ->type_name("KIND");
}

}  // namespace boxprobe
