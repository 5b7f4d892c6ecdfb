// A scene with its probes in one .glb: the model as it was, and the extension BOXPROBE_reflection_probes, which
// data/glb/README.md specifies. Other programs show the model; this one opens the scene with its maps as they were
// baked. Knows neither captures nor windows.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "filters/core/geometry/probe_diffuse.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/cube_file.h"

namespace boxprobe {

constexpr const char* kGlbExtension = "BOXPROBE_reflection_probes";

struct GlbScene {
  Scene scene;  ///< cameras and lights filled in
  /// Of scene.probes, in their order; nothing: the probe goes without a map. Without an inputHash other programs see
  /// the map, and this one captures anew.
  std::vector<std::optional<BakedProbeFile>> maps;
  std::optional<BakedProbeFile> sky;  ///< the sky as rough surfaces reflect it
  ProbesDiffuse diffuse;              ///< may be empty
  std::string writer;                 ///< "Boxprobe 0.1.0"
};

/// The bytes of the file. `models`: the scene's, as they were read. A single .glb or .gltf is taken in as it is, others
/// as documentOfModels() has them (glb_models.h). `path` is for messages. Throws InputError for a scene without models,
/// for pictures of several files, and for more than a .glb holds.
std::string glbWithProbes(const GlbScene& content, const std::vector<std::shared_ptr<const Model>>& models,
                          const std::string& path);

/// Throws InputError if the scene's maps, of the sizes its probes ask for, cannot fit into a .glb, or if its models
/// cannot: to be called before anything is captured.
void requireGlbScene(const Scene& scene, const std::string& path);

/// Is it a .glb with the extension? Reads the JSON alone. False for files that cannot be read.
bool holdsProbes(const std::string& path);

/// The scene in the file; pictures are those in `folder`, where unpackGlb() puts them. Validated. Throws InputError:
/// one line with the file and the place in the extension.
Scene glbSceneOf(const std::string& path, const std::string& folder);

/// Writes the file's pictures and its maps, these as files of a BakeFolder in `folder`/probes, into a new or empty
/// folder. Equal files give equal bytes. Throws InputError as above, WorkError for the file system's failures.
void unpackGlb(const std::string& path, const std::string& folder);

}  // namespace boxprobe
