// The scenes of the baseline: a room in which every number is another one and every kind of material occurs. Written as
// files, since the program reads files.
#pragma once

#include <string>

namespace boxprobe::test {

/// Writes NAME.boxprobe.json for each scene, and their models and pictures, into a folder:
/// - odd: the room, in metres
/// - finish: the same with one probe
/// - plain: its walls and blocks alone, of plain materials
/// - far: that, far from the origin
/// - big, small: the same, 100 times as large and 1/100 as large
/// - inches: the same, as an OBJ file in inches, z up
/// - bare: of one probe, with the model's cameras and lights
/// - halls: walls for `place`: three rooms with doorways, a lintel, a low store; in metres
/// - halls-cm: the same plan, 100 times as large
void writeBaselineScenes(const std::string& folder);

}  // namespace boxprobe::test
