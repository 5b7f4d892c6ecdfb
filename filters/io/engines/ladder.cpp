#include "filters/io/engines/ladder.h"

#include <algorithm>
#include <cmath>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

namespace {

// Our own lookup: alpha = (2^l - 1) / (2^L - 1), shaders/shared/roughness.glsl.
double ownRoughness(int level, int levels, int) {
  return std::sqrt((std::exp2(level) - 1.0) / (std::exp2(levels - 1) - 1.0));
}

// three.js r187, src/extras/PMREMGenerator.js: the last level has 8 x 8 texels, and lodToRoughness() is the inverse of
// level = maxLod r (2 - r).
int threeLevels(int faceSize) {
  return std::max(fullLevels(faceSize) - 3, 1);
}
double threeRoughness(int level, int levels, int) {
  return levels > 1 ? 1.0 - std::sqrt(1.0 - static_cast<double>(level) / (levels - 1)) : 0.0;
}

// Bevy 0.19, crates/bevy_pbr/src/light_probe/environment_map.wesl: level = roughness (levels - 1), for any number of
// levels. Ours end with 4 x 4 texels, which still resolve the lobe of roughness 1.
double linearRoughness(int level, int levels, int) {
  return levels > 1 ? static_cast<double>(level) / (levels - 1) : 0.0;
}

// Babylon.js 9, pbrIBLFunctions (getLodFromAlphaG) and Filtering/hdrFiltering: level = 0.8 log2(N alpha), and level 0
// is the mirror. Nothing samples levels beyond alpha = 1, but the loader requires them.
double babylonRoughness(int level, int, int faceSize) {
  constexpr double kLodGenerationScale = 0.8;
  return level == 0 ? 0.0 : std::sqrt(std::min(std::exp2(level / kLodGenerationScale) / faceSize, 1.0));
}

// Unity's built-in and universal pipelines, perceptualRoughnessToMipmapLevel: level = 6 r (1.7 - 0.7 r), for any number
// of levels.
double unityRoughness(int level, int, int) {
  constexpr double kSteps = 6.0;
  return level >= kSteps ? 1.0 : (1.7 - std::sqrt(1.7 * 1.7 - 2.8 * level / kSteps)) / 1.4;
}

}  // namespace

const std::vector<LadderRow>& ladderRows() {
  static const std::vector<LadderRow> rows = {
      {"own", "Boxprobe's own shaders (export --shader), Godot, Unreal, and engines that filter themselves",
       "alpha = (2^l - 1) / (2^L - 1), L the last level; roughness = sqrt(alpha)", prefilterLevels, ownRoughness,
       glm::vec3(1.0f), glm::vec3(0.0f, 0.0f, 1.0f), false},
      {"three", "three.js r187 and later (isPMREMTexture); PlayCanvas and Blender, which filter themselves",
       "roughness = 1 - sqrt(1 - l / L), L = log2(N) - 3 the last level", threeLevels, threeRoughness,
       glm::vec3(-1.0f, 1.0f, 1.0f), glm::vec3(1.0f, 0.0f, 0.0f), false},
      {"bevy", "Bevy 0.19", "roughness = l / L, L the last level", prefilterLevels, linearRoughness,
       glm::vec3(1.0f, 1.0f, -1.0f), glm::vec3(0.0f, 0.0f, 1.0f), true},
      {"babylon", "Babylon.js 9, left-handed scenes", "alpha = min(2^(l / 0.8) / N, 1); roughness = sqrt(alpha)",
       fullLevels, babylonRoughness, glm::vec3(-1.0f, 1.0f, 1.0f), glm::vec3(1.0f, 0.0f, 0.0f), false},
      {"unity", "Unity, glTF imported with x negated", "l = 6 roughness (1.7 - 0.7 roughness); 1 from level 6 on",
       fullLevels, unityRoughness, glm::vec3(-1.0f, 1.0f, 1.0f), glm::vec3(1.0f, 0.0f, 0.0f), false},
  };
  return rows;
}

const LadderRow* findLadder(std::string_view id) {
  for (const LadderRow& row : ladderRows()) {
    if (row.id == id) return &row;
  }
  return nullptr;
}

std::string ladderIdList() {
  std::string list;
  for (const LadderRow& row : ladderRows()) list += (list.empty() ? "" : ", ") + std::string(row.id);
  return list;
}

}  // namespace boxprobe
