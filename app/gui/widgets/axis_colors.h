// The colours of the window's drawings: X red, Y green, Z blue as everywhere, and what tells box, blend and origin
// apart before light and dark pictures alike. Called by the handles and the panel's labels.
#pragma once

#include <QColor>

namespace boxprobe {

QColor axisColor(int axis);  ///< 0, 1, 2
QColor boxColor();           ///< edges of the selected probe's box
QColor blendColor();         ///< where the probe has its full weight
QColor influenceColor();     ///< an influence box of its own
QColor originColor();        ///< capture origin
QColor idleColor();          ///< probes that are not selected
QColor ghostColor();         ///< a box that is proposed
QColor haloColor();          ///< around all of them

}  // namespace boxprobe
