// The colours of boxes and handles (filters/vtk/widgets/handle_colors.h) for Qt: labels, icons, the compass.
#pragma once

#include <QColor>

namespace boxprobe {

QColor axisColor(int axis);  ///< 0, 1, 2
QColor boxColor();           ///< edges of the selected probe's box
QColor blendColor();         ///< where the probe has its full weight
QColor influenceColor();     ///< an influence box of its own
QColor originColor();        ///< capture origin
QColor haloColor();          ///< around all of them

}  // namespace boxprobe
