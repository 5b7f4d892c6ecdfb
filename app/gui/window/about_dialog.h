// What the program is, and its mouse and keys on one page. Called by the menu.
#pragma once

class QWidget;

namespace boxprobe {

void showAbout(QWidget* parent);

}  // namespace boxprobe
