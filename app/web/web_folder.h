// A scene as a folder for any web server: page, scripts, and what web_scene.h makes. Called by `boxprobe export`.
#pragma once

#include <string>
#include <vector>

#include "app/web/web_scene.h"

namespace boxprobe {

/// Writes into an existing folder, the page last; returns the paths. `title` stands above the picture. Throws WorkError
/// for the file system's failures.
std::vector<std::string> writeWebFolder(const WebScene& scene, const std::string& title, const std::string& folder);

}  // namespace boxprobe
