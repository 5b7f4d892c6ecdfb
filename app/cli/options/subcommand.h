// What every sub-command is to main: its arguments and what runs it. And the options that all of them have.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace boxprobe {

struct Subcommand {
  CLI::App* arguments = nullptr;  ///< owned by the program's CLI::App
  std::function<void()> run;      ///< called once, if the arguments were given; throws Error
};

struct ReportOptions {
  std::string statsPath;  ///< empty: none asked for
  bool json = false;
  bool quiet = false;
};

/// `jsonHelp`: what --json of this sub-command prints.
inline void addReportOptions(CLI::App& command, ReportOptions& options, const std::string& jsonHelp) {
  command.add_option("--stats", options.statsPath, "Write counters and times to this file")->type_name("FILE.json");
  command.add_flag("--json", options.json, jsonHelp);
  command.add_flag("--quiet", options.quiet, "Print errors only: no progress, warnings or summary");
}

}  // namespace boxprobe
