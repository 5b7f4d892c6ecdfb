// What the program is, and its mouse and keys. Called by the menu.
#pragma once

class QDialog;
class QWidget;

namespace boxprobe {

/// Not shown yet; no larger than the screen and a window of 1024 x 700, its text scrolls. Deleted by `parent` or
/// whoever closes it.
QDialog* aboutDialog(QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace boxprobe
