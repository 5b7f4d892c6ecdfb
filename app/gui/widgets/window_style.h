// The look of the window: Fusion in quiet dark greys, so that the picture is the brightest thing, with letters large
// enough for a projector. Called once at the start of the window and of its tests.
#pragma once

class QApplication;

namespace boxprobe {

/// The kind of GL context the picture needs. Before the QApplication is constructed.
void setSurfaceFormat();

void applyWindowStyle(QApplication& application);

}  // namespace boxprobe
