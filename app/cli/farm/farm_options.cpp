// See farm_options.h.
#include "app/cli/farm/farm_options.h"

#include <filesystem>
#include <utility>

#include "app/cli/farm/bake_share.h"
#include "app/session/output_check.h"
#include "filters/core/base/errors.h"
#include "filters/platform/process.h"

namespace boxprobe {

void addFarmOptions(CLI::App& command, FarmOptions& options) {
  auto* shard = command.add_option("--shard", options.shard,
                                   "Make share I of N and keep it in FILE.parts beside the output; auto: the place in "
                                   "a Slurm array job, under mpiexec or srun");
  shard->type_name("I/N|auto");
  auto* merge = command.add_flag("--merge", options.merge,
                                 "Put together what shares have made, make what is missing, write the output");
  auto* emit = command.add_option("--emit", options.script, "Print a script that works with many processes");
  emit->check(CLI::IsMember({"slurm", "parallel", "make"}).description(""))->type_name("slurm|parallel|make");
  command.add_option("--shards", options.shares, "Number of shares for --emit (default 16)")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->needs(emit);
  merge->excludes(shard);
  emit->excludes(shard);
  emit->excludes(merge);
}

std::unique_ptr<SharedWork> sharedWork(const FarmOptions& options, const std::string& output, const std::string& key) {
  if (!options.any()) return nullptr;
  const std::string option = options.merge ? "--merge" : "--shard";
  if (output.empty()) throw InputError(option + ": add -o FILE; what shares make is kept beside that file");
  const BakeShare share = options.merge ? BakeShare{0, 1} : parseBakeShare(options.shard);
  const std::string folder = SharedWork::folderOf(output);
  requireOutputFolder(option, folder);
  return std::make_unique<SharedWork>(folder, key, share.index, share.count);
}

std::string shareText(const SharedWork& shared) {
  return "share " + std::to_string(shared.index()) + " of " + std::to_string(shared.count()) + ": " +
         std::to_string(shared.made()) + " result(s) kept in " + shared.folder() + ", " +
         std::to_string(shared.found()) + " taken over\n";
}

std::string farmScript(const FarmOptions& options, FarmWork work) {
  work.program = programPath().empty() ? "boxprobe" : programPath();
  work.shares = options.shares;
  return farmScript(options.script, work);
}

std::string farmPath(const std::string& path) {
  return std::filesystem::absolute(path).string();
}

}  // namespace boxprobe
