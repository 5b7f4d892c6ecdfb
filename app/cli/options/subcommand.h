// What every sub-command is to main: its arguments and what runs it. And the options that all of them have.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/session/offscreen_choice.h"
#include "filters/platform/process.h"

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

/// In which of its states a glTF file is read; they become fields of the scene's first model, as --set would set them.
inline void addModelOptions(CLI::App& command, std::vector<std::string>& assignments) {
  const auto add = [&](const char* flag, const char* field, const char* help, bool text) {
    return command.add_option_function<std::string>(
        flag,
        [&assignments, field, text](const std::string& value) {
          const std::string json = text ? nlohmann::json(value).dump() : value;
          assignments.push_back("models.0." + std::string(field) + "=" + json);
        },
        help);
  };
  add("--variant", "variant", "Materials of the (first) glTF model: one of its variants, which info lists", true)
      ->type_name("NAME");
  add("--time", "time", "Show the (first) glTF model's animations at this time in seconds", false)->type_name("S");
}

/// `jsonHelp`: what --json of this sub-command prints.
inline void addReportOptions(CLI::App& command, ReportOptions& options, const std::string& jsonHelp) {
  command.add_option("--stats", options.statsPath, "Write counters and times to this file")->type_name("FILE.json");
  command.add_flag("--json", options.json, jsonHelp);
  command.add_flag("--quiet", options.quiet, "Print errors only: no progress, warnings or summary");
}

/// For what draws. The environment hands it on to processes that this one starts.
inline void addTuningOption(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--renderer-tuning",
          [](const std::string& value) { setEnvironment("BOXPROBE_RENDERER_TUNING", value.c_str(), true); },
          "Draw in the way that is faster on a graphics card (gpu) or on the CPU (cpu), whatever the driver; the same "
          "picture (default auto: by the driver's name)")
      ->check(CLI::IsMember({"auto", "cpu", "gpu"}).description(""))
      ->type_name("KIND");
}

/// Errors are measured with textures that are not sampled anisotropically: the same on every driver. Before any window;
/// BOXPROBE_ANISOTROPY in the environment comes first.
inline void measureWithoutAnisotropy() {
  setEnvironment("BOXPROBE_ANISOTROPY", "1", false);
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
  addTuningOption(command);
}

}  // namespace boxprobe
