// In the place of TBB's parallel_for in the ThreadSanitizer build, by the include path: the same loop on plain threads.
// TBB comes from the system, not instrumented, and ThreadSanitizer sees neither how it hands a task to another thread
// nor how a loop ends before its caller goes on. Suppressing what follows from that would suppress every race within a
// task as well. Here both are seen, and between the threads of a loop nothing is ordered but by what its body does: no
// queue and no counter that could order two steps by chance. Only what this project uses of TBB is here.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/partitioner.h>

#include <exception>
#include <thread>
#include <vector>

namespace boxprobe_threads {

constexpr int kThreads = 4;         // more than there may be processors: they alternate
constexpr std::size_t kParts = 32;  // of a range that may be cut anywhere

/// The parts of `range`, cut down to its grain or until there are `most`.
template <typename Range>
std::vector<Range> partsOf(const Range& range, std::size_t most) {
  std::vector<Range> parts;
  if (range.empty()) return parts;
  parts.push_back(range);
  for (bool cut = true; cut && parts.size() < most;) {
    cut = false;
    for (std::size_t i = 0, count = parts.size(); i < count && parts.size() < most; ++i) {
      if (!parts[i].is_divisible()) continue;
      Range other(parts[i], tbb::split());
      parts.push_back(other);
      cut = true;
    }
  }
  return parts;
}

/// The caller takes its share, as it does with TBB. Rethrows the first exception by the order of threads.
template <typename Range, typename Body>
void run(const Range& range, const Body& body, std::size_t most) {
  const std::vector<Range> parts = partsOf(range, most);
  std::exception_ptr errors[kThreads];
  const auto share = [&](int first) {
    try {
      for (std::size_t i = static_cast<std::size_t>(first); i < parts.size(); i += kThreads) {
        Range part = parts[i];
        body(part);
      }
    } catch (...) {
      errors[first] = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < kThreads && static_cast<std::size_t>(i) < parts.size(); ++i) others.emplace_back(share, i);
  share(0);
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace boxprobe_threads

namespace tbb {

template <typename Range, typename Body>
void parallel_for(const Range& range, const Body& body) {
  boxprobe_threads::run(range, body, boxprobe_threads::kParts);
}

template <typename Range, typename Body>
void parallel_for(const Range& range, const Body& body, const simple_partitioner&) {
  boxprobe_threads::run(range, body, static_cast<std::size_t>(-1));
}

template <typename Index, typename Function>
void parallel_for(Index first, Index last, const Function& function) {
  parallel_for(blocked_range<Index>(first, last), [&](const blocked_range<Index>& part) {
    for (Index i = part.begin(); i < part.end(); ++i) function(i);
  });
}

}  // namespace tbb
