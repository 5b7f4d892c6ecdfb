// The options by which several processes share a work whose results go into a folder beside the output: --shard,
// --merge, --emit, --shards. (`bake` has its own, whose results are the output.)
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/farm/farm_script.h"
#include "app/cli/options/subcommand.h"
#include "app/session/shared_work.h"

namespace boxprobe {

struct FarmOptions {
  std::string shard;   ///< "I/N" or "auto"; empty: alone
  std::string script;  ///< kind of script to print; empty: none
  int shares = 16;     ///< of that script
  bool merge = false;
  bool any() const { return merge || !shard.empty(); }
};

void addFarmOptions(CLI::App& command, FarmOptions& options);

/// What is kept beside `output`, of this key; null for a process that works alone. Throws InputError without an output.
std::unique_ptr<SharedWork> sharedWork(const FarmOptions& options, const std::string& output, const std::string& key);

/// "share 2 of 8: 5 result(s) kept in FILE.parts, 3 taken over".
std::string shareText(const SharedWork& shared);

/// The script; `work` has all but program and shares.
std::string farmScript(const FarmOptions& options, FarmWork work);

/// An absolute path: scripts run elsewhere.
std::string farmPath(const std::string& path);

}  // namespace boxprobe
