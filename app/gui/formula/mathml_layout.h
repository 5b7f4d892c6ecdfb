// Sets presentation MathML: the elements a lesson's formulas use, each as a box of outlines. Called by formula_picture;
// knows no widget and no colour.
#pragma once

#include <QString>

#include "app/gui/formula/math_box.h"

namespace boxprobe {

/// In units of the base font's em, baseline at y = 0. What is no MathML is set as plain text, so that nothing is lost;
/// elements that are not known are rows. Needs a QGuiApplication, for its fonts.
MathBox layoutMathml(const QString& mathml);

}  // namespace boxprobe
