// Runs a function when a scope ends, also by an exception, where no destructor would do it otherwise.
#pragma once

#include <functional>
#include <utility>

namespace boxprobe {

class AtEnd {
 public:
  /// `call` must not throw.
  explicit AtEnd(std::function<void()> call) : call_(std::move(call)) {}
  ~AtEnd() { call_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  std::function<void()> call_;
};

}  // namespace boxprobe
