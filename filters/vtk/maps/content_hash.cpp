#include "filters/vtk/maps/content_hash.h"

#include <xxhash.h>

#include <cstdio>
#include <new>

namespace boxprobe {

ContentHash::ContentHash() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_128bits_reset(state_.get());
}

void ContentHash::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

ContentHash& ContentHash::addBytes(const void* data, std::size_t size) {
  if (size > 0) XXH3_128bits_update(state_.get(), data, size);
  return *this;
}

ContentHash& ContentHash::add(double value) {
  const double canonical = value == 0.0 ? 0.0 : value;
  return addBytes(&canonical, sizeof canonical);
}

ContentHash& ContentHash::add(std::string_view text) {
  add(static_cast<double>(text.size()));
  return addBytes(text.data(), text.size());
}

std::string ContentHash::text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
  char digits[33];
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits;
}

}  // namespace boxprobe
