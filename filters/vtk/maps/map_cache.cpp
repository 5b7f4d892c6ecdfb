#include "filters/vtk/maps/map_cache.h"

#include <algorithm>

namespace boxprobe {

std::shared_ptr<const ProbeMaps> MapCache::find(const std::string& key) const {
  const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
  return it != entries_.end() ? it->maps : nullptr;
}

std::shared_ptr<const ProbeMaps> MapCache::findFace(int face, const std::string& faceKey) const {
  if (faceKey.empty()) return nullptr;
  const auto index = static_cast<std::size_t>(face);
  const auto it =
      std::find_if(entries_.rbegin(), entries_.rend(), [&](const Entry& e) { return e.faces[index] == faceKey; });
  return it != entries_.rend() ? it->maps : nullptr;
}

void MapCache::add(const std::string& key, FaceKeys faces, std::shared_ptr<const ProbeMaps> maps) {
  forget(key);
  entries_.push_back({key, std::move(faces), std::move(maps)});
  std::size_t total = bytes();
  for (auto it = entries_.begin(); it != entries_.end() && total > kept_;) {
    if (it->maps.use_count() > 1) {  // in use by a probe or by work in progress
      ++it;
      continue;
    }
    total -= it->maps->bytes();
    it = entries_.erase(it);
  }
}

void MapCache::forget(const std::string& key) {
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; }),
                 entries_.end());
}

std::size_t MapCache::bytes() const {
  std::size_t bytes = 0;
  for (const Entry& entry : entries_) bytes += entry.maps->bytes();
  return bytes;
}

}  // namespace boxprobe
