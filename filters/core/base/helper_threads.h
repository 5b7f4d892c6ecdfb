// Threads that help the caller's own with work that any number of them can share. Used by whatever reads or resamples
// pictures; knows nothing of the work.
#pragma once

#include <algorithm>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace boxprobe {

/// How many threads may share work that is worth `most` of them, the caller's own included.
inline std::size_t threadsFor(std::size_t most) {
  return std::max<std::size_t>(1, std::min<std::size_t>(std::thread::hardware_concurrency(), most));
}

class HelperThreads {
 public:
  /// `count` threads at most, each of which runs `work` once, which must not throw. Fewer, or none, where the system
  /// gives no more: the caller does the work then.
  HelperThreads(std::size_t count, const std::function<void()>& work) {
    threads_.reserve(count);
    try {
      while (threads_.size() < count) threads_.emplace_back(work);
    } catch (const std::system_error&) {
    }
  }
  ~HelperThreads() { join(); }
  HelperThreads(const HelperThreads&) = delete;
  HelperThreads& operator=(const HelperThreads&) = delete;

  void join() {
    for (std::thread& thread : threads_) {
      if (thread.joinable()) thread.join();
    }
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace boxprobe
