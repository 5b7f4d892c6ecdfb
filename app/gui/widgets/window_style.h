// The look of the window: Fusion in quiet greys, so that the picture is the brightest thing, or in light ones for
// bright rooms, with letters large enough for a projector. Called at the start of the window and of its tests, and
// where the user chooses another look.
#pragma once

#include <QColor>

class QApplication;

namespace boxprobe {

/// The kind of GL context the picture needs. Before the QApplication is constructed.
void setSurfaceFormat();

enum class Theme {
  System,  ///< the desktop's own where there is one; else dark
  Dark,
  Light,
};

void applyWindowStyle(QApplication& application, Theme theme = Theme::Dark);

/// Colours beside the palette's, as the look on show has them.
enum class StyleColor {
  Accent,      ///< of text: what matters, what can be tried
  Dim,         ///< of text: explanations
  Good,        ///< of text: a task solved
  Bad,         ///< of text: an error
  Deciding,    ///< ground of a row that decides
  Remarkable,  ///< ground of a remark
};
QColor styleColor(StyleColor color);

/// Contrast of two colours by WCAG 2.1, 1 to 21.
double contrast(const QColor& one, const QColor& other);
/// `color`, lighter or darker by as much as text on `ground` needs: a contrast of 4.5.
QColor readable(const QColor& color, const QColor& ground);

}  // namespace boxprobe
