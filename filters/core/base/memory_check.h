#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace boxprobe {

/// To be called where a library or a driver failed without a reason: throws std::bad_alloc if the process gets no more
/// than a little memory (512 MB), which is the reason then.
inline void requireMemory() {
  constexpr std::size_t kLittle = std::size_t(512) << 20;
  void* volatile taken = std::malloc(kLittle);  // volatile: compilers leave out what nobody uses
  if (taken == nullptr) throw std::bad_alloc();
  std::free(taken);
}

}  // namespace boxprobe
