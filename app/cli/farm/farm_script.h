// A bake as work for others: Slurm's array jobs, GNU parallel, make. One command a share and bounce; all shares of a
// bounce end before the next one begins, and the last command checks what there is.
#pragma once

#include <string>

namespace boxprobe {

struct FarmBake {
  std::string program, scene, folder;  ///< paths as they are to be called
  std::string options;                 ///< of the command line, each with a space in front: --set and its like
  int shares = 1;
  int bounces = 1;
};

/// `kind`: "slurm", "parallel" (both scripts for sh) or "make" (a Makefile).
std::string farmScript(const std::string& kind, const FarmBake& bake);

/// `text` as one word of sh.
std::string shellWord(const std::string& text);

}  // namespace boxprobe
