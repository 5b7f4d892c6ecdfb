// A scene as data/web/room.js draws it in a browser (WebGL2): one JSON text and the binary files that it names. Shared
// by the folder of `boxprobe export --format web` and the page of lessons. Knows no file system.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/engines/probe_export.h"

namespace boxprobe {

struct WebFile {
  std::string name, mime, bytes;
};

struct WebScene {
  std::string json;                  ///< names the files below, with the CRC-32 of each under "sums"
  std::vector<WebFile> files;        ///< vertices, textures, cubemaps (KTX2), the split-sum table
  std::vector<std::string> remarks;  ///< what the browser will not show as the program does, one sentence each
};

/// `models` in the order of scene.models; `captures` of all probes of the scene, in its order. `faceSize`: of the
/// cubemaps, a power of two, at most that of the captures; 0: each as captured. World space, scene units, as the scene.
/// Throws InputError for values that half floats do not hold.
WebScene webScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                  const std::vector<ProbeCapture>& captures, int faceSize, const std::string& writer);

/// The JSON with each file inside it as a data URL under "files", for a page that has nothing beside it.
std::string withinOneText(const WebScene& scene);

}  // namespace boxprobe
