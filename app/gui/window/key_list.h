// The window's mouse and keys: what they do, for the overlay over the picture and the About box. Called by both.
#pragma once

#include <QString>

namespace boxprobe {

/// Rows of two columns, rich text.
QString keyTable();

}  // namespace boxprobe
