#include "app/cli/farm/farm_script.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/core/base/printable_text.h"

namespace boxprobe {

namespace {

std::string command(const FarmBake& bake) {
  std::string text = shellWord(bake.program) + " bake " + shellWord(bake.scene) + " -o " + shellWord(bake.folder);
  for (const std::string& option : bake.options) text += " " + shellWord(option);
  return text;
}

/// Of one bounce, as far as its --shard. A single bounce needs no word about it.
std::string shareCommand(const FarmBake& bake, int bounce) {
  return command(bake) + " --quiet" + (bake.bounces > 1 ? " --bounce " + std::to_string(bounce) : "") + " --shard ";
}

std::string slurm(const FarmBake& bake) {
  const std::string array = "--array=1-" + std::to_string(bake.shares);
  std::string text =
      "#!/bin/sh\n"
      "# Submits the bake to Slurm: one array job per bounce, then a job that fails unless all is done. Further "
      "options "
      "for\n"
      "# sbatch: $SBATCH_OPTIONS. Where a task fails, run this again: what is done stays done.\n"
      "set -eu\n";
  for (int bounce = 1; bounce <= bake.bounces; ++bounce) {
    // Not afterok: what a bounce left undone, the next one makes for itself.
    const std::string after = bounce == 1 ? "" : " --dependency=\"afterany:$job\"";
    text += "job=$(sbatch --parsable ${SBATCH_OPTIONS:-} " + array + after + " --job-name=boxprobe-bake --wrap " +
            shellWord(shareCommand(bake, bounce) + "auto") + ")\n";
  }
  return text +
         "sbatch --parsable ${SBATCH_OPTIONS:-} --dependency=\"afterany:$job\" --job-name=boxprobe-check --wrap " +
         shellWord(command(bake) + " --merge") + "\n";
}

/// GNU parallel fills in whatever looks like {}, {.}, {1} or {=perl=} before its shell sees the command. A brace never
/// stands outside of quotes here (see shellWord); closing and opening them after each leaves nothing to fill in.
std::string unfilled(const std::string& shellText) {
  std::string result;
  for (const char c : shellText) result += c == '{' ? "{''" : std::string(1, c);
  return result;
}

std::string parallel(const FarmBake& bake) {
  const std::string count = std::to_string(bake.shares);
  std::string text =
      "#!/bin/sh\n"
      "# Bakes by GNU parallel. Further options for it (-j N, --sshloginfile FILE): $PARALLEL.\n"
      "set -eu\n"
      "export PARALLEL_SHELL=/bin/sh\n";
  for (int bounce = 1; bounce <= bake.bounces; ++bounce) {
    text += "seq " + count + " | parallel " + shellWord(unfilled(shareCommand(bake, bounce)) + "{}/" + count) + "\n";
  }
  return text + command(bake) + " --merge\n";
}

/// A word of sh in a Makefile.
std::string recipe(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '$' ? "$$" : std::string(1, c);
  return result;
}

std::string make(const FarmBake& bake) {
  std::string text = "# make -j N -f THIS-FILE bakes with N processes at a time.\n.PHONY: all";
  std::string rules, before;
  for (int bounce = 1; bounce <= bake.bounces; ++bounce) {
    std::string shares;
    for (int share = 1; share <= bake.shares; ++share) {
      const std::string target = "bounce-" + std::to_string(bounce) + "-" + std::to_string(share);
      shares += " " + target;
      rules += target + ":" + before + "\n\t" + recipe(shareCommand(bake, bounce)) + std::to_string(share) + "/" +
               std::to_string(bake.shares) + "\n";
    }
    // A target in between: each share of the next bounce would name all of this one's.
    const std::string barrier = "bounce-" + std::to_string(bounce);
    rules += barrier + ":" + shares + "\n";
    text += shares + " " + barrier;
    before = " " + barrier;
  }
  return text + "\nall:" + before + "\n\t" + recipe(command(bake)) + " --merge\n" + rules;
}

}  // namespace

std::string shellWord(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./,:@%+=") == std::string::npos;
  if (plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string farmScript(const std::string& kind, const FarmBake& bake) {
  std::vector<std::string> words = {bake.program, bake.scene, bake.folder};
  words.insert(words.end(), bake.options.begin(), bake.options.end());
  for (const std::string& word : words) {
    if (std::none_of(word.begin(), word.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) continue;
    throw InputError("--emit " + kind + ": \"" + printable(word) +
                     "\" has a control character in it, such as a line break; a script cannot carry it, rename it");
  }
  return kind == "slurm" ? slurm(bake) : kind == "parallel" ? parallel(bake) : make(bake);
}

}  // namespace boxprobe
