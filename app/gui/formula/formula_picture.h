// A formula as a picture, from MathML: for the lesson panel, printed sheets and the page, which need the same letters.
// Called by the lesson panel and by whoever makes sheets and pages; needs a QGuiApplication (the offscreen platform
// will do), no window.
#pragma once

#include <QColor>
#include <QImage>
#include <QString>

namespace boxprobe {

/// On transparent ground, cropped to the formula with a hair's breadth around it. `pointSize` is the size of its
/// letters at 96 dots an inch; `scale` device pixels per logical pixel, which the image's device pixel ratio says.
QImage formulaPicture(const QString& mathml, double pointSize, const QColor& color, double scale);

/// The same as an inline <svg> of outlines in the colour of the text around it, whose em it takes and on whose baseline
/// it stands. Hidden from screen readers: they read the MathML.
QString formulaSvg(const QString& mathml);

}  // namespace boxprobe
