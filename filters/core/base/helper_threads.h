// Threads that help the caller's thread with work that any number of threads can share.
#pragma once

#include <algorithm>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace boxprobe {

/// How many threads should share work that can use `most` of them, the caller's included.
inline std::size_t threadsFor(std::size_t most) {
  return std::max<std::size_t>(1, std::min<std::size_t>(std::thread::hardware_concurrency(), most));
}

class HelperThreads {
 public:
  /// Runs `work`, which must not throw, once on each of at most `count` threads. There are fewer, or none, if the
  /// system refuses more; the caller then does the work.
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
