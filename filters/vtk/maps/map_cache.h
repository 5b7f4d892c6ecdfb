// Maps made before, by what they show: undo costs nothing, a further bounce starts from the one before, a face that did
// not change is kept. Called by the probe set; knows no probe.
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
  /// Maps that nobody shows any more are kept up to so many bytes.
  explicit MapCache(std::size_t bytes) : kept_(bytes) {}

  std::shared_ptr<const ProbeMaps> find(const std::string& key) const;
  /// Maps of which this one face is known to be the same.
  std::shared_ptr<const ProbeMaps> findFace(int face, const std::string& faceKey) const;
  /// `faces` may be empty texts: those are never found.
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
  std::vector<Entry> entries_;  ///< most recently made last
};

}  // namespace boxprobe
