// The user's choices that outlive the window and belong to no scene.
#pragma once

#include <optional>

namespace boxprobe {

/// Cheaper techniques while the camera or a handle moves; nothing until the user has chosen.
std::optional<bool> cheaperWhileMoving();
void keepCheaperWhileMoving(bool on);

}  // namespace boxprobe
