// A folder of baked probes, one EXR file each, with the keys that tell whether a file is still valid.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// The inputs that a probe's maps were made from.
struct BakeRecord {
  std::string key;   ///< of the maps: equal keys mean equal pictures
  std::string view;  ///< key of what the capture shows directly: without the light from other probes
  /// Views of the probes that later bounces show, and of all probes there were. Moving a probe's box changes what it
  /// lights without making the bake stale; adding a probe makes it stale.
  std::vector<std::string> sees, known;

  /// One line; stored as the hash in a file's header.
  std::string text() const;
  static std::optional<BakeRecord> parse(const std::string& text);
};

/// What wrote a file. All files of one bake should have the same maker, because others round differently.
struct BakeMaker {
  std::string program;   ///< "Boxprobe 0.2"
  std::string renderer;  ///< OpenGL's name of the renderer that captured; empty: unknown
  bool operator==(const BakeMaker& other) const { return program == other.program && renderer == other.renderer; }
};

class BakeFolder {
 public:
  BakeFolder() = default;
  /// Reads the header of every EXR file in `path`. A folder that does not exist counts as empty.
  explicit BakeFolder(std::string path);

  const std::string& path() const { return path_; }
  /// Is there a file with these maps, intact by its checksum? Each file is checked once, when it is first asked for.
  bool has(const std::string& key) const;
  /// Its path and maker, for a key that exists.
  const std::string& file(const std::string& key) const { return files_.at(key).path; }
  const BakeMaker& maker(const std::string& key) const { return files_.at(key).maker; }
  /// A line for each file found damaged so far; its probe counts as not baked.
  const std::vector<std::string>& damaged() const { return damaged_; }
  /// The record of a file whose capture showed `view`.
  std::optional<BakeRecord> record(const std::string& view) const;
  /// Throws InputError if the file has been damaged since.
  BakedMaps load(const std::string& key) const;
  /// Treats the file as absent from now on; `damage` says why, if it is damaged.
  void forget(const std::string& key, const std::string& damage = {});

  /// Writes `folder`/fileName(name), creating the folder. `earlierBounce`: number of a bounce before the last, which
  /// other probes need for theirs; its file is written beside the final one. Throws WorkError.
  static std::string save(const std::string& folder, const Probe& probe, const BakeRecord& record, BakedMaps maps,
                          const BakeMaker& maker, int earlierBounce = 0);
  /// A probe's name as a file name: characters that are special to a file system or shell are written %XX. The empty
  /// name is the sky's.
  static std::string fileName(const std::string& probeName, int earlierBounce = 0);
  /// Is it the name of a file of an earlier bounce?
  static bool isEarlierBounce(const std::string& fileName);
  /// The folder of a scene's probes by default: NAME.probes beside NAME.boxprobe.json.
  static std::string besideScene(const std::string& scenePath);

 private:
  struct File {
    std::string path;
    BakeRecord record;
    BakeMaker maker;
    bool checked = false;
  };
  std::string path_;
  // Checked on demand, by const functions.
  mutable std::map<std::string, File> files_;  ///< by key
  std::multimap<std::string, std::string> keysOfView_;
  mutable std::vector<std::string> damaged_;
};

}  // namespace boxprobe
