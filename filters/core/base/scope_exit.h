// Runs a function when a scope ends, also by an exception, where no destructor would do it otherwise.
#pragma once

#include <functional>
#include <utility>

namespace boxprobe {

class ScopeExit {
 public:
  /// `call` must not throw.
  explicit ScopeExit(std::function<void()> call) : call_(std::move(call)) {}
  ~ScopeExit() { call_(); }
  ScopeExit(const ScopeExit&) = delete;
  ScopeExit& operator=(const ScopeExit&) = delete;

 private:
  std::function<void()> call_;
};

}  // namespace boxprobe
