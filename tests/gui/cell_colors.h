// A picture in few numbers, and how many of them another picture has alike.
#pragma once

#include <QImage>
#include <string>

namespace boxprobe {

constexpr int kCells = 24;  ///< across and down

/// Width, height, and the mean colour of each cell, two hexadecimal digits a channel; "x3" behind what stands three
/// times in a row.
std::string cellColors(const QImage& image);

/// Cells in which a channel differs by more than `most` of 255; all, if the sizes do.
int differingCells(const std::string& now, const std::string& before, int most);

/// Widths of letters and the version of Qt: pictures with words differ where this does.
std::string fontsNow();

}  // namespace boxprobe
