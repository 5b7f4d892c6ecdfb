#include "app/cli/farm/farm_script.h"

#include <algorithm>
#include <cctype>

#include "filters/core/base/errors.h"
#include "filters/core/base/printable_text.h"

namespace boxprobe {

namespace {

std::string command(const FarmWork& work) {
  std::string text = shellWord(work.program);
  for (const std::string& word : work.words) text += " " + shellWord(word);
  return text;
}

/// Of one step, as far as its --shard.
std::string shareCommand(const FarmWork& work, const std::vector<std::string>& step) {
  std::string text = command(work) + " --quiet";
  for (const std::string& word : step) text += " " + shellWord(word);
  return text + " --shard ";
}

std::string slurm(const FarmWork& work) {
  const std::string array = "--array=1-" + std::to_string(work.shares);
  std::string text =
      "#!/bin/sh\n"
      "# Submits the " +
      work.noun + " to Slurm: one array job per " + work.step +
      ", then a job that fails unless all is done. Further options for\n"
      "# sbatch: $SBATCH_OPTIONS. Where a task fails, run this again: what is done stays done.\n"
      "set -eu\n";
  bool first = true;
  for (const std::vector<std::string>& step : work.steps) {
    // Not afterok: what a step left undone, the next one makes for itself.
    const std::string after = first ? "" : " --dependency=\"afterany:$job\"";
    first = false;
    text += "job=$(sbatch --parsable ${SBATCH_OPTIONS:-} " + array + after + " --job-name=boxprobe-" + work.name +
            " --wrap " + shellWord(shareCommand(work, step) + "auto") + ")\n";
  }
  return text +
         "sbatch --parsable ${SBATCH_OPTIONS:-} --dependency=\"afterany:$job\" --job-name=boxprobe-check --wrap " +
         shellWord(command(work) + " --merge") + "\n";
}

/// GNU parallel fills in whatever looks like {}, {.}, {1} or {=perl=} before its shell sees the command. A brace never
/// stands outside of quotes here (see shellWord); closing and opening them after each leaves nothing to fill in.
std::string unfilled(const std::string& shellText) {
  std::string result;
  for (const char c : shellText) result += c == '{' ? "{''" : std::string(1, c);
  return result;
}

std::string sentenceStart(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

std::string parallel(const FarmWork& work) {
  const std::string count = std::to_string(work.shares);
  std::string text =
      "#!/bin/sh\n"
      "# " +
      sentenceStart(work.name) +
      "s by GNU parallel. Further options for it (-j N, --sshloginfile FILE): $PARALLEL.\n"
      "set -eu\n"
      "export PARALLEL_SHELL=/bin/sh\n";
  for (const std::vector<std::string>& step : work.steps) {
    text += "seq " + count + " | parallel " + shellWord(unfilled(shareCommand(work, step)) + "{}/" + count) + "\n";
  }
  return text + command(work) + " --merge\n";
}

/// A word of sh in a Makefile.
std::string recipe(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '$' ? "$$" : std::string(1, c);
  return result;
}

std::string make(const FarmWork& work) {
  std::string text = "# make -j N -f THIS-FILE " + work.name + "s with N processes at a time.\n.PHONY: all";
  std::string rules, before;
  for (std::size_t step = 0; step < work.steps.size(); ++step) {
    std::string shares;
    for (int share = 1; share <= work.shares; ++share) {
      const std::string target = work.step + "-" + std::to_string(step + 1) + "-" + std::to_string(share);
      shares += " " + target;
      rules += target + ":" + before + "\n\t" + recipe(shareCommand(work, work.steps[step])) + std::to_string(share) +
               "/" + std::to_string(work.shares) + "\n";
    }
    // A target in between: each share of the next step would name all of this one's.
    const std::string barrier = work.step + "-" + std::to_string(step + 1);
    rules += barrier + ":" + shares + "\n";
    text += shares + " " + barrier;
    before = " " + barrier;
  }
  return text + "\nall:" + before + "\n\t" + recipe(command(work)) + " --merge\n" + rules;
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

std::string farmScript(const std::string& kind, const FarmWork& work) {
  std::vector<std::string> words = {work.program};
  words.insert(words.end(), work.words.begin(), work.words.end());
  for (const std::string& word : words) {
    if (std::none_of(word.begin(), word.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) continue;
    throw InputError("--emit " + kind + ": \"" + printable(word) +
                     "\" has a control character in it, such as a line break; a script cannot carry it, rename it");
  }
  return kind == "slurm" ? slurm(work) : kind == "parallel" ? parallel(work) : make(work);
}

}  // namespace boxprobe
