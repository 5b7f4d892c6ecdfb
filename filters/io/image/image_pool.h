// Decoded pictures of the whole process by the bytes they were decoded from: a picture that two models use, or of a
// model that is opened again while it is shown, is decoded once. Holds weak references only.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/platform/process.h"

namespace boxprobe {

struct EncodedImage {
  const unsigned char* data = nullptr;
  std::size_t size = 0;
  std::string place;  ///< for messages: file and image
  std::string name;   ///< what the picture is called
};

struct ImageCounts {
  std::uint64_t decoded = 0;  ///< since the program started
  std::uint64_t shared = 0;   ///< requested and found in memory
};

class ImagePool {
 public:
  /// PNG, JPEG or WebP pictures in the requested order, decoded on as many threads as there are cores. `progress` is
  /// called between pictures, by one thread at a time, with the finished fraction; what it throws ends the work. A
  /// picture that cannot be read is null, and its entry of `problems` says why, in one line.
  std::vector<std::shared_ptr<const ImageRgba8>> decode(const std::vector<EncodedImage>& images,
                                                        const std::function<void(double)>& progress,
                                                        std::vector<std::string>& problems);
  ImageCounts counts() const;
  /// Of the pictures of one call, decoded; more is an InputError with the picture's place. 0: no limit. At first a
  /// sixth of the machine's memory, since drawing takes about four times the pictures' own.
  void setMostBytes(std::uint64_t bytes) { mostBytes_ = bytes; }
  std::uint64_t mostBytes() const { return mostBytes_; }

 private:
  using Key = std::array<std::uint64_t, 2>;
  static Key keyOf(const EncodedImage& image);

  mutable std::mutex mutex_;
  std::map<Key, std::weak_ptr<const ImageRgba8>> known_;
  ImageCounts counts_;
  std::uint64_t mostBytes_ = physicalMemoryBytes() / 6;
};

ImagePool& imagePool();

}  // namespace boxprobe
