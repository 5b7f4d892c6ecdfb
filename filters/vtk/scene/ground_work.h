// The ground's shadow of a scene, traced in a thread of its own and again where what stands in the scene is another.
// Called by the scene renderer at each frame; draws nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/ground_shadow.h"

namespace boxprobe {

class GroundWork {
 public:
  GroundWork() = default;
  ~GroundWork();
  GroundWork(const GroundWork&) = delete;
  GroundWork& operator=(const GroundWork&) = delete;

  /// What is to be known from now on. `key` tells what stands in the scene apart; `bounds` (world) hold what is seen.
  void ask(const std::string& key, const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
           const SightLinesMaker& lines, const Box& bounds);
  /// Nothing is, and nothing is shown.
  void forget();
  /// Is something asked for that is not known?
  bool pending() const { return run_ != nullptr; }
  /// What is known, perhaps of what was asked for before; waits a little for what is not. Null: nothing. Throws
  /// WorkError once where the tracer failed.
  std::shared_ptr<const GroundShadow> shadow(std::chrono::milliseconds wait);

 private:
  struct Run {
    std::atomic<bool> stop{false};
    std::future<GroundShadow> result;
  };
  void end();

  std::string key_;
  std::unique_ptr<Run> run_;
  std::shared_ptr<const GroundShadow> known_;
};

}  // namespace boxprobe
