// A long work by several processes, on one machine or many: each keeps what it has made as files in one folder, and
// takes over what the others have kept. No word passes between them. What is missing or damaged, because a process was
// killed, is made again by whoever needs it. Used by `boxprobe place` and `report` with --shard.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "filters/fit/shared_fits.h"
#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

class SharedWork final : public SharedFits {
 public:
  /// `key`: fingerprint of all that the results depend on; files of another key are never taken. Share `index` of
  /// `count`, from 1; with `index` 0 nothing is mine alone.
  SharedWork(std::string folder, std::string key, int index, int count);

  /// The folder beside an output file: "FILE.parts".
  static std::string folderOf(const std::string& output) { return output + ".parts"; }

  bool mine(std::size_t number) const override;
  /// Is this a process that makes its share and leaves the result to another?
  bool sharing() const { return index_ > 0; }

  std::optional<BoxFit> find(const std::string& name, const Probe& start) const override;
  void keep(const std::string& name, const BoxFit& fit) const override;

  /// Of that size: a file may hold anything.
  std::optional<ReferencePicture> findTraced(const std::string& name, int width, int height) const;
  void keepTraced(const std::string& name, const ReferencePicture& picture) const;
  std::optional<ImageRgbaF> findPicture(const std::string& name, int width, int height) const;
  void keepPicture(const std::string& name, const ImageRgbaF& picture) const;
  std::optional<std::string> findBytes(const std::string& name) const;
  void keepBytes(const std::string& name, const std::string& bytes) const;

  int index() const { return index_; }
  int count() const { return count_; }
  const std::string& folder() const { return folder_; }
  /// Results taken over, and made, by this process.
  std::size_t found() const { return found_; }
  std::size_t made() const { return made_; }

  /// Removes the files of this key, and the folder if that empties it.
  void remove() const;

 private:
  std::string pathOf(const std::string& name) const;

  std::string folder_, key_;
  int index_, count_;
  mutable std::size_t found_ = 0, made_ = 0;
};

/// Fingerprint of a scene as it was loaded: its fields, the content of its models, where they stand, its sky and the
/// pictures of its probes, and the version of this program.
std::string loadedSceneKey(const LoadedScene& loaded);

}  // namespace boxprobe
