#include "filters/vtk/maps/lamp_free_maps.h"

#include <algorithm>
#include <new>

#include "filters/core/base/errors.h"
#include "filters/math/cube/lamp_free.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

namespace {

CubeMap levelZero(const CubeTexture& texture) {
  if (!texture.allocated()) return {};
  CubeMap cube(texture.faceSize(), 1);
  readLevel0(texture, cube);
  return cube;
}

bool sameShape(const LampPolygon& a, const LampPolygon& b) {
  return a.count == b.count && a.bothSides == b.bothSides && a.corners == b.corners;
}

// Of what the capture shows beyond `free`, the mean of the colours.
void putLampsIntoAlpha(const CubeMap& capture, CubeMap& free) {
  const int size = free.faceSize();
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const glm::vec3 without(free.texel(0, face, column, row));
        const glm::vec3 lamps = glm::vec3(capture.texel(0, face, column, row)) - without;
        const float mean = (lamps.x + lamps.y + lamps.z) / 3.0f;
        free.setTexel(0, face, column, row, glm::vec4(without, std::max(mean, 0.0f)));
      }
    }
  }
}

}  // namespace

bool makeLampFreeMaps(const ProbeMaps& maps, const std::vector<LampPolygon>& lamps, LevelMask levels, bool dragged,
                      const ChainFilter& filter) {
  ProbeMaps::LampFree& free = maps.lampFree;
  if (free.refused || !filter || !maps.radiance.allocated()) return false;
  const bool same = std::equal(lamps.begin(), lamps.end(), free.of.begin(), free.of.end(), sameShape);
  try {
    if (!free.maps || (!same && !dragged)) {
      const CubeMap capture = levelZero(maps.radiance);
      CubeMap without = withoutLamps(capture, levelZero(maps.distance), lamps);
      free.backgrounds = lampBackgrounds(without, lamps);
      putLampsIntoAlpha(capture, without);
      auto made = std::make_shared<ProbeMaps>();
      made->radiance.allocate(maps.radiance.faceSize(), maps.radiance.levels(), GL_RGBA16F);
      uploadLevel0(without, made->radiance);
      // Lookups of whole levels may touch the next one with a weight of 0, which must be finite.
      for (int level = 1; level < made->radiance.levels(); ++level) {
        const auto side = static_cast<std::size_t>(made->radiance.faceSize() >> level);
        for (int face = 0; face < 6; ++face) made->radiance.writeFace(face, level, std::vector<float>(4 * side * side));
      }
      made->filtered = 1u;
      free.maps = std::move(made);
      free.of = lamps;
    }
    const LevelMask missing = free.maps->missing(levels);
    if (missing == 0) return true;
    filter(free.maps->radiance, missing);
    free.maps->filtered |= missing;
    free.maps->flat.release();
  } catch (const std::bad_alloc&) {  // none of these may pass through a draw
    free.refused = true;
  } catch (const WorkError&) {
    free.refused = true;
  }
  if (free.refused) free.maps.reset();
  return !free.refused;
}

}  // namespace boxprobe
