// A folder of baked probes, one EXR file each, and what says whether one still holds. Written by `boxprobe bake` and
// the window, read by everything that draws a scene. Knows neither VTK nor Qt.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// What a probe's maps were made from.
struct BakeRecord {
  std::string key;   ///< of the maps: equal keys, equal pictures
  std::string view;  ///< of what the capture shows directly: the key without the light that other probes throw into it
  /// Views of the probes its later bounces show, and of all probes there were. Kept so that moving a probe's box, which
  /// changes what it lights, does not undo the bake, while a probe that is new does.
  std::vector<std::string> sees, known;

  /// One line; the hash in a file's header.
  std::string text() const;
  static std::optional<BakeRecord> parse(const std::string& text);
};

/// Whose work a file is. Files of one bake have one maker: others round differently.
struct BakeMaker {
  std::string program;   ///< "Boxprobe 0.2"
  std::string renderer;  ///< OpenGL's name of what captures; empty: not known
  bool operator==(const BakeMaker& other) const { return program == other.program && renderer == other.renderer; }
};

class BakeFolder {
 public:
  BakeFolder() = default;
  /// Looks at the header of every EXR file in `path`. A folder that is not there is an empty one.
  explicit BakeFolder(std::string path);

  const std::string& path() const { return path_; }
  /// Is there a file with these maps, whole by its checksum? Each file is read for that once, when it is first asked
  /// for.
  bool has(const std::string& key) const;
  /// Its path and maker, for a key that the folder has.
  const std::string& file(const std::string& key) const { return files_.at(key).path; }
  const BakeMaker& maker(const std::string& key) const { return files_.at(key).maker; }
  /// A line for each file that was found damaged so far; its probe has no file.
  const std::vector<std::string>& damaged() const { return damaged_; }
  /// The record of a file whose capture showed `view`.
  std::optional<BakeRecord> record(const std::string& view) const;
  /// Throws InputError if the file with these maps was damaged since.
  BakedMaps load(const std::string& key) const;
  /// From here on as if the file were not there; `damage` is why, if it is damaged.
  void forget(const std::string& key, const std::string& damage = {});

  /// Writes `folder`/fileName(name), creating the folder. `earlierBounce`: of a bounce before the last, which others
  /// need for theirs; its file stands beside the final one. Throws WorkError.
  static std::string save(const std::string& folder, const Probe& probe, const BakeRecord& record, BakedMaps maps,
                          const BakeMaker& maker, int earlierBounce = 0);
  /// A probe's name as a file name: what is special to any file system or shell is written %XX. The empty name is the
  /// sky.
  static std::string fileName(const std::string& probeName, int earlierBounce = 0);
  /// Is that the name of a file of an earlier bounce?
  static bool isEarlierBounce(const std::string& fileName);
  /// Where a scene's probes lie if nothing else is said: NAME.probes beside NAME.boxprobe.json.
  static std::string besideScene(const std::string& scenePath);

 private:
  struct File {
    std::string path;
    BakeRecord record;
    BakeMaker maker;
    bool checked = false;
  };
  std::string path_;
  // Checked when they are asked for, which is a question still.
  mutable std::map<std::string, File> files_;  ///< by key
  std::multimap<std::string, std::string> keysOfView_;
  mutable std::vector<std::string> damaged_;
};

}  // namespace boxprobe
