// What the bytes of a model's file may become when it is read: a few of them may unpack to many, and be named any
// number of times, which no limit on a single use bounds.
#pragma once

#include <cstdint>
#include <string>

namespace boxprobe {

/// What even the smallest file may come to, in bytes. At first a sixth of the machine's memory, as a file's pictures
/// (image_pool.h); 0: no limit. Tests lower it.
std::uint64_t& readBudgetBytes();

class ReadBudget {
 public:
  /// Of the file and of those beside it, each once: they allow for more.
  void allow(std::uint64_t ownBytes) { own_ += ownBytes; }
  /// For all bytes that are read or made from the file's own. Throws InputError with `place` ("a.glb: accessor 3")
  /// beyond readBudgetBytes() and 16 times what is allowed for.
  void count(std::uint64_t bytes, const std::string& place);
  std::uint64_t counted() const { return counted_; }

 private:
  std::uint64_t own_ = 0, counted_ = 0;
};

}  // namespace boxprobe
