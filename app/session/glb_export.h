// A scene as one .glb with its probes: captures what is missing, and puts together what
// filters/io/engines/glb_probes.h writes. Called by `boxprobe export`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_choice.h"
#include "app/session/stats_json.h"

namespace boxprobe {

class InterruptGuard;
class OffscreenScene;
struct GlbScene;

struct GlbWishes {
  std::string path;         ///< of the file, for messages
  std::string bakedFolder;  ///< its files are used where they hold; empty: none
  Offscreen offscreen = Offscreen::Automatic;
  bool quiet = false;
};

/// Keeps its window and what it has captured, so that a scene that changed is written again sooner.
class GlbExporter {
 public:
  explicit GlbExporter(GlbWishes wishes);
  ~GlbExporter();
  GlbExporter(const GlbExporter&) = delete;
  GlbExporter& operator=(const GlbExporter&) = delete;

  /// The bytes of the file. Throws InputError for what does not go into a .glb, before anything is captured; WorkError
  /// if it was interrupted or something could not be captured.
  std::string bytes(const LoadedScene& loaded, const InterruptGuard& interrupt);
  /// The same at once, with the maps, lattices and lamps of the last call of bytes(): a box that was moved is seen
  /// before anything is captured. Empty before that.
  std::string bytesOfBefore(const LoadedScene& loaded) const;
  RunStats stats() const;

 private:
  GlbWishes wishes_;
  std::unique_ptr<OffscreenScene> shown_;
  std::unique_ptr<GlbScene> written_;  ///< by the last call
};

/// What programs look at that follow a file, or a folder, which is written again and again: FILE.revision, or
/// FOLDER/revision, with the number of times. To be written after it. Throws WorkError.
void writeRevision(const std::string& output, int revision);
/// The number that stands there; 0 if there is none.
int lastRevision(const std::string& output);

}  // namespace boxprobe
