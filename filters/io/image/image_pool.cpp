#include "filters/io/image/image_pool.h"

#include <xxhash.h>

#include <algorithm>
#include <atomic>
#include <exception>

#include "filters/core/base/errors.h"
#include "filters/core/base/helper_threads.h"
#include "filters/core/base/number_text.h"
#include "filters/io/image/image_detail.h"

namespace boxprobe {

namespace {

struct TooManyPixels {};

}  // namespace

ImagePool& imagePool() {
  static ImagePool pool;
  return pool;
}

// With 128 bits a collision of keys is practically impossible.
ImagePool::Key ImagePool::keyOf(const EncodedImage& image) {
  const XXH128_hash_t hash = XXH3_128bits(image.data, image.size);
  return {hash.low64, hash.high64};
}

ImageCounts ImagePool::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

std::vector<std::shared_ptr<const ImageRgba8>> ImagePool::decode(const std::vector<EncodedImage>& images,
                                                                 const std::function<void(double)>& progress,
                                                                 std::vector<std::string>& problems) {
  std::vector<std::shared_ptr<const ImageRgba8>> result(images.size());
  problems.assign(images.size(), {});
  std::vector<std::size_t> missing;
  std::map<Key, std::size_t> first;  // of equal pictures in this call
  std::vector<Key> keys;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < images.size(); ++i) {
      keys.push_back(keyOf(images[i]));
      const auto found = known_.find(keys[i]);
      if (found != known_.end()) result[i] = found->second.lock();
      if (result[i] || !first.emplace(keys[i], i).second) {
        ++counts_.shared;
      } else {
        missing.push_back(i);
      }
    }
  }

  std::vector<std::exception_ptr> failures(images.size());
  std::atomic<std::size_t> next{0}, done{0};
  std::atomic<bool> stopped{false};
  std::atomic<std::uint64_t> decoded{0};  // bytes
  const auto decodeNext = [&] {
    const std::size_t at = next++;
    if (at >= missing.size() || stopped) return false;
    const EncodedImage& image = images[missing[at]];
    try {
      ImageRgba8 picture = decodeImage8(image.data, image.size, image.place);
      picture.name = image.name;
      if ((decoded += picture.pixels.size()) > mostBytes_ && mostBytes_ > 0) {
        stopped = true;
        throw TooManyPixels();
      }
      result[missing[at]] = std::make_shared<const ImageRgba8>(std::move(picture));
    } catch (const TooManyPixels&) {
      failures[missing[at]] = std::make_exception_ptr(
          InputError(image.place + ": with the model's other pictures it comes to more than " +
                     gigabytesText(mostBytes_) + ", a sixth of this machine's memory; use smaller pictures"));
    } catch (const InputError& problem) {
      problems[missing[at]] = problem.what();
    } catch (...) {
      failures[missing[at]] = std::current_exception();
    }
    ++done;
    return true;
  };
  HelperThreads helpers(threadsFor(missing.size()) - 1, [&] {
    while (decodeNext()) {
    }
  });
  // The caller's thread also decodes, and reports progress between pictures.
  std::exception_ptr cancelled;
  while (decodeNext()) {
    try {
      if (progress) progress(static_cast<double>(done) / static_cast<double>(missing.size()));
    } catch (...) {
      cancelled = std::current_exception();
      stopped = true;
    }
  }
  helpers.join();
  if (cancelled) std::rethrow_exception(cancelled);
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }

  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.decoded += missing.size();
  for (const std::size_t i : missing) {
    if (result[i]) known_[keys[i]] = result[i];
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (!result[i]) result[i] = result[first.at(keys[i])];
  }
  for (auto entry = known_.begin(); entry != known_.end();) {
    entry = entry->second.expired() ? known_.erase(entry) : std::next(entry);
  }
  return result;
}

}  // namespace boxprobe
