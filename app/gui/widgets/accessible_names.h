// Names of controls for who hears the window instead of seeing it: from the labels beside them, else from their tips.
// Called once the window, or a part of it, is built.
#pragma once

class QWidget;

namespace boxprobe {

/// Every control in `root` without a name gets one. Controls in one row of a form are told apart by their tips.
void nameControls(QWidget* root);

}  // namespace boxprobe
