#include "filters/vtk/maps/lamp_free_maps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <new>

#include "filters/core/base/errors.h"
#include "filters/math/cube/lamp_free.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

namespace {

CubeMap levelZero(const CubeTexture& texture) {
  if (!texture.allocated()) return {};
  CubeMap cube(texture.faceSize(), 1);
  readLevel0(texture, cube);
  return cube;
}

bool sameMapLamp(const MapLamp& a, const MapLamp& b) {
  return a.shape.count == b.shape.count && a.shape.bothSides == b.shape.bothSides &&
         a.shape.corners == b.shape.corners && a.radiance == b.radiance;
}

// By how much of the sphere each fills, seen from the origin: what the map shows of it.
glm::vec3 lampsColor(const std::vector<MapLamp>& lamps) {
  glm::vec3 sum(0.0f);
  for (const MapLamp& lamp : lamps) {
    glm::vec3 area(0.0f), middle(0.0f);
    for (int i = 0; i < lamp.shape.count; ++i) {
      const glm::vec3& a = lamp.shape.corners[static_cast<std::size_t>(i)];
      area += glm::cross(a, lamp.shape.corners[static_cast<std::size_t>((i + 1) % lamp.shape.count)]);
      middle += a / static_cast<float>(lamp.shape.count);
    }
    const float d = std::max(glm::length(middle), 1.0e-6f);
    sum += std::min(std::abs(glm::dot(area, middle)) / (d * d * d), 12.0f) * lamp.radiance;
  }
  const float largest = std::max({sum.x, sum.y, sum.z});
  return largest > 0.0f ? sum / largest : glm::vec3(1.0f);
}

// Of what the capture shows beyond `free`, in multiples of `tint`.
void putLampsIntoAlpha(const CubeMap& capture, const glm::vec3& tint, CubeMap& free) {
  const float norm = 1.0f / glm::dot(tint, tint);
  const int size = free.faceSize();
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const glm::vec3 without(free.texel(0, face, column, row));
        const glm::vec3 lamps = glm::vec3(capture.texel(0, face, column, row)) - without;
        free.setTexel(0, face, column, row, glm::vec4(without, std::max(norm * glm::dot(lamps, tint), 0.0f)));
      }
    }
  }
}

}  // namespace

bool LampFreeMaps::make(const ProbeMaps& maps, const std::vector<MapLamp>& lamps, LevelMask levels, bool dragged,
                        const Filter& filter) {
  if (refused_ || !filter || !maps.radiance.allocated()) return false;
  const bool same = std::equal(lamps.begin(), lamps.end(), lamps_.begin(), lamps_.end(), sameMapLamp);
  try {
    if (!maps_ || (!same && !dragged)) {
      const CubeMap capture = levelZero(maps.radiance);
      std::vector<LampPolygon> shapes;
      for (const MapLamp& lamp : lamps) shapes.push_back(lamp.shape);
      CubeMap free = withoutLamps(capture, levelZero(maps.distance), shapes);
      tint_ = lampsColor(lamps);
      putLampsIntoAlpha(capture, tint_, free);
      auto made = std::make_shared<ProbeMaps>();
      made->radiance.allocate(maps.radiance.faceSize(), maps.radiance.levels(), GL_RGBA16F);
      uploadLevel0(free, made->radiance);
      // Lookups of whole levels may touch the next one with a weight of 0, which must be finite.
      for (int level = 1; level < made->radiance.levels(); ++level) {
        const auto side = static_cast<std::size_t>(made->radiance.faceSize() >> level);
        for (int face = 0; face < 6; ++face) made->radiance.writeFace(face, level, std::vector<float>(4 * side * side));
      }
      made->filtered = 1u;
      maps_ = std::move(made);
      lamps_ = lamps;
    }
    const LevelMask missing = maps_->missing(levels);
    if (missing == 0) return true;
    filter(maps_->radiance, missing);
    maps_->filtered |= missing;
    maps_->flat.release();
  } catch (const std::bad_alloc&) {  // none of these may pass through a draw
    refused_ = true;
  } catch (const WorkError&) {
    refused_ = true;
  }
  if (refused_) maps_.reset();
  return !refused_;
}

std::size_t LampFreeMaps::bytes() const {
  return maps_ ? maps_->bytes() : 0;
}

}  // namespace boxprobe
