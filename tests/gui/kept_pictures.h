// Pictures that a test paints, against those that a file of values keeps: as the mean colours of 24 x 24 cells.
#pragma once

#include <QImage>
#include <map>
#include <string>

namespace boxprobe {

/// Pictures and texts by name, against a file as kept_values.h has them. A cell may differ by `most` of 255 in a
/// channel. Where the fonts or Qt are not the file's, no picture is compared, and the test is skipped once the texts
/// have been.
void expectKeptPictures(const std::string& file, const std::map<std::string, QImage>& pictures,
                        const std::map<std::string, std::string>& texts, int most);

}  // namespace boxprobe
