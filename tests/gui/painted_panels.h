// More of what painted_test.cpp compares: marks of the outliner, pages of lessons, formulas, drawings of odd rays.
#pragma once

#include <QImage>
#include <functional>
#include <map>
#include <string>

class QPainter;
class QWidget;

namespace boxprobe {

void addPaintedPanels(std::map<std::string, QImage>& pictures);

/// On the window's ground, in letters of 9 points.
QImage painted(int width, int height, const std::function<void(QPainter&)>& paint);
QImage grabbed(QWidget& widget, int width, int height);

/// Colours all over, no two rows or columns alike.
QImage someColors(int width, int height);

}  // namespace boxprobe
