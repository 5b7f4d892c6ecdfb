// A bake as work for others: Slurm's array jobs, GNU parallel, make. One command a share and bounce; all shares of a
// bounce end before the next one begins, and the last command checks what there is.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct FarmBake {
  std::string program, scene, folder;  ///< paths as they are to be called
  /// Of the command line, words of their own: "--set" and what follows it.
  std::vector<std::string> options;
  int shares = 1;
  int bounces = 1;
};

/// `kind`: "slurm", "parallel" (both scripts for sh) or "make" (a Makefile). Throws InputError naming what has a line
/// break or another control character in it: no form of a Makefile's recipe or of Slurm's --wrap carries those.
std::string farmScript(const std::string& kind, const FarmBake& bake);

/// `text` as one word of sh.
std::string shellWord(const std::string& text);

}  // namespace boxprobe
