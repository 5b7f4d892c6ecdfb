// The user's choices that outlive the window and belong to no scene.
#pragma once

#include <QString>
#include <optional>

namespace boxprobe {

/// Where they are kept.
QString preferencesFile();

/// Cheaper techniques while the camera or a handle moves; nothing until the user has chosen.
std::optional<bool> cheaperWhileMoving();
void keepCheaperWhileMoving(bool on);

}  // namespace boxprobe
