// Something that is traced of a scene as it stands still, in a thread of its own, and again where what stands in the
// scene is another. Asked by the scene renderer at each frame; draws nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>

namespace boxprobe {

template <typename Result>
class TracedWork {
 public:
  using Stop = std::function<bool()>;

  TracedWork() = default;
  ~TracedWork() { end(); }
  TracedWork(const TracedWork&) = delete;
  TracedWork& operator=(const TracedWork&) = delete;

  /// What is to be known from now on. `key` tells what stands in the scene apart; `trace` is called in the thread, and
  /// what it returns once `stop` says true is thrown away.
  void ask(const std::string& key, std::function<Result(const Stop& stop)> trace) {
    if (key == key_) return;
    end();
    key_ = key;
    run_ = std::make_unique<Run>();
    run_->result = std::async(std::launch::async, [trace = std::move(trace), stop = &run_->stop] {
      return trace([stop] { return stop->load(); });
    });
  }
  /// Nothing is, and nothing is shown.
  void forget() {
    end();
    key_.clear();
    known_.reset();
  }
  /// Is something asked for that is not known?
  bool pending() const { return run_ != nullptr; }
  /// What is known, perhaps of what was asked for before; waits a little for what is not. Null: nothing. Throws
  /// WorkError once where the tracer failed.
  std::shared_ptr<const Result> known(std::chrono::milliseconds wait = std::chrono::milliseconds(0)) {
    if (run_ && run_->result.wait_for(wait) == std::future_status::ready) {
      const std::unique_ptr<Run> ended = std::move(run_);
      known_ = std::make_shared<const Result>(ended->result.get());
    }
    return known_;
  }

 private:
  struct Run {
    std::atomic<bool> stop{false};
    std::future<Result> result;
  };
  void end() {
    if (!run_) return;
    run_->stop = true;
    if (run_->result.valid()) run_->result.wait();
    run_.reset();
  }

  std::string key_;
  std::unique_ptr<Run> run_;
  std::shared_ptr<const Result> known_;
};

}  // namespace boxprobe
