// Work for others as a script: Slurm's array jobs, GNU parallel, make. One command per share and step; all shares of a
// step end before the next one begins, and the last command puts together or checks what there is.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct FarmWork {
  std::string program;        ///< path as it is to be called, see programPath()
  std::string name;           ///< of the sub-command
  std::string noun;           ///< what it does, after "the"
  std::string step = "step";  ///< word for one
  /// Of every command line, behind the program: the sub-command, the scene, "--set" and what follows it.
  std::vector<std::string> words;
  std::vector<std::vector<std::string>> steps = {{}};  ///< further words of the shares' commands, per step
  int shares = 1;
};

/// `kind`: "slurm", "parallel" (both scripts for sh) or "make" (a Makefile). Throws InputError naming what has a line
/// break or another control character in it: no form of a Makefile's recipe or of Slurm's --wrap carries those.
std::string farmScript(const std::string& kind, const FarmWork& work);

/// `text` as one word of sh.
std::string shellWord(const std::string& text);

}  // namespace boxprobe
