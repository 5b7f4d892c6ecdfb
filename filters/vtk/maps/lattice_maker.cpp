#include "filters/vtk/maps/lattice_maker.h"

#include <algorithm>

#include "filters/math/cube/lamp_free.h"

namespace boxprobe {

namespace {

CubeMap firstLevel(const CubeTexture& texture) {
  if (!texture.allocated()) return {};
  CubeMap cube(texture.faceSize(), 1);
  for (int face = 0; face < 6; ++face) texture.readFace(face, 0, cube.face(0, face));
  return cube;
}

bool sameLamp(const LampPolygon& a, const LampPolygon& b) {
  return a.count == b.count && a.bothSides == b.bothSides && a.corners == b.corners;
}

}  // namespace

bool LatticeSource::operator==(const LatticeSource& o) const {
  return boxMin == o.boxMin && boxMax == o.boxMax && mapFromProbe == o.mapFromProbe &&
         worldFromProbe == o.worldFromProbe && projection == o.projection && traced == o.traced &&
         std::equal(lamps.begin(), lamps.end(), o.lamps.begin(), o.lamps.end(), sameLamp);
}

std::shared_ptr<const DiffuseLattice> LatticeMaker::of(const CubeTexture& radiance, const CubeTexture& distance,
                                                       const LatticeSource& source, bool dragged) {
  if (lattice_ && (dragged || source == source_)) return lattice_;
  if (!radiance.allocated()) return nullptr;
  CubeMap capture = firstLevel(radiance);
  if (!source.lamps.empty()) capture = withoutLamps(capture, firstLevel(distance), source.lamps);
  source_ = source;
  shading::ProbeShape shape{};
  shape.boxMin = source.boxMin;
  shape.boxMax = source.boxMax;
  shape.projection = source.projection;
  const CubeMap means = plainMeans(capture);
  const DiffuseLattice projected = makeDiffuseLattice(means, shape, source.mapFromProbe, source.worldFromProbe);
  lattice_ = std::make_shared<const DiffuseLattice>(tracedLattice(projected, means, source.traced));
  return lattice_;
}

}  // namespace boxprobe
