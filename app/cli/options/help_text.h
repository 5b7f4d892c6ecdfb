// How the help of a command is set: headings, one line an option or sub-command, the footer as it was written. CLI11's
// own formatter sets it in another way from 2.5 on (wrapped, in capitals, examples run together); manual pages and
// shell completions are made from this text, so it is the same with every version.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxprobe {

class HelpText : public CLI::Formatter {
 public:
  /// The whole help of `app`; `name`: the command as it is called. `mode` changes nothing: no command shows its
  /// sub-commands' help.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace boxprobe
