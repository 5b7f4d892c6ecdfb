// Keys by their place on the keyboard, where a layout has something else there: the digits of AZERTY, which need Shift,
// and letters of layouts without Latin ones. Called by whatever takes keys of the picture.
#pragma once

class QKeyEvent;

namespace boxprobe {

/// What the key is on a QWERTY keyboard, if it has no Latin letter or digit of its own; else what it is. Knows the
/// codes of X11 and Wayland.
int keyByPlace(const QKeyEvent& event);

}  // namespace boxprobe
