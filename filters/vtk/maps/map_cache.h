// Maps made earlier, by key: undo is free, a further bounce starts from the one before, and unchanged faces are reused.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/maps/face_keys.h"
#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

class MapCache {
 public:
  /// Keeps unused maps up to this many bytes.
  explicit MapCache(std::size_t bytes) : kept_(bytes) {}

  std::shared_ptr<const ProbeMaps> find(const std::string& key) const;
  /// Maps in which this face is known to be the same.
  std::shared_ptr<const ProbeMaps> findFace(int face, const std::string& faceKey) const;
  /// Empty `faces` are never found.
  void add(const std::string& key, FaceKeys faces, std::shared_ptr<const ProbeMaps> maps);
  void forget(const std::string& key);
  void clear() { entries_.clear(); }
  std::size_t bytes() const;

 private:
  struct Entry {
    std::string key;
    FaceKeys faces;
    std::shared_ptr<const ProbeMaps> maps;
  };
  std::size_t kept_;
  std::vector<Entry> entries_;  ///< the newest last
};

}  // namespace boxprobe
