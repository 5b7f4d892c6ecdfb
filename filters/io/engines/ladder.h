// What an engine expects of a prefiltered cubemap: the number of levels, the roughness of each, and the axes. One row
// per engine, in ladderRows(); the formulas are from the engines' sources, named beside each.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace boxprobe {

struct LadderRow {
  std::string_view id;
  std::string_view help;     ///< one line
  std::string_view formula;  ///< roughness of a level, as text for documents and exported files
  /// The number of levels for `faceSize` texels per side, a power of two of at least kLeastExportSize.
  int (*levels)(int faceSize);
  /// Perceptual roughness of a level: 0 at level 0, never above 1.
  double (*roughness)(int level, int levels, int faceSize);
  /// The engine samples the cube with its world direction times this (each ±1), because its axes may not be
  /// right-handed.
  glm::vec3 lookup;
  /// The direction in the middle of a latitude-longitude picture; the top is +Y, and someone inside sees it unmirrored.
  glm::vec3 latLongCentre;
  bool diffuse;  ///< reads irradiance from a second cube
};

constexpr int kLeastExportSize = 16, kMostExportSize = 2048;

const std::vector<LadderRow>& ladderRows();
/// Null if there is no row of that id.
const LadderRow* findLadder(std::string_view id);
/// "own, three, ..." for messages.
std::string ladderIdList();

}  // namespace boxprobe
