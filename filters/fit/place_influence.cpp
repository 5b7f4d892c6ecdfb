// See place_influence.h.
#include "filters/fit/place_influence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

constexpr double kSkin = 0.018;    // of the rooms' height, behind a wall: less than half of a thin wall
constexpr double kMostGap = 0.25;  // of the rooms' height: the maximum thickness of a wall

/// Boxes of a probe are given as if not rotated about the middle of its projection box; `axes` are rotated about the
/// world's origin.
Box alongAxes(const Box& box, const Probe& probe) {
  const glm::dvec3 pivot = probe.box.center();
  const glm::dvec3 off = glm::transpose(rotationMatrix(probe.rotationDegrees)) * pivot - pivot;
  return {box.min + off, box.max + off};
}

Box asOfProbe(const Box& along, const Probe& probe) {
  const glm::dvec3 pivot = probe.box.center();
  const glm::dvec3 off = glm::transpose(rotationMatrix(probe.rotationDegrees)) * pivot - pivot;
  return {along.min - off, along.max - off};
}

double side(const Box& box, int axis, bool upper) {
  return (upper ? box.max : box.min)[axis];
}

/// The walls around some cells, along the axes of a probe: where rays from the cells end close to the outermost ones.
Box wallsOf(const SurfaceRays& rays, const FreeSpace& space, const std::vector<std::size_t>& cells,
            const Probe& probe) {
  constexpr std::size_t kLooks = 400, kLeast = 5;
  const glm::dmat3 worldFromAxes = rotationMatrix(probe.rotationDegrees), axesFromWorld = glm::transpose(worldFromAxes);
  Box walls = extentOf(space, cells, worldFromAxes);
  const std::size_t stride = std::max<std::size_t>(1, cells.size() / kLooks);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const double out = upper ? 1.0 : -1.0;
      double& wall = (upper ? walls.max : walls.min)[axis];
      std::vector<double> ends;
      for (std::size_t i = 0; i < cells.size(); i += stride) {
        const glm::dvec3 from = space.worldPosition(cells[i]), along = out * worldFromAxes[axis];
        const std::optional<SurfaceHit> hit = rays.first(from, along);
        if (!hit) continue;
        const double end = (axesFromWorld * (from + hit->distance * along))[axis];
        if (std::abs(end - wall) <= 1.5 * space.cell) ends.push_back(out * end);
      }
      if (ends.size() < kLeast) {
        wall += 0.5 * out * space.cell;
        continue;
      }
      const auto most = ends.begin() + static_cast<std::ptrdiff_t>(0.97 * static_cast<double>(ends.size() - 1));
      std::nth_element(ends.begin(), most, ends.end());
      wall = out * *most;
    }
  }
  return walls;
}

/// The axis along which a doorway leads, in other axes than the grid's.
glm::dvec3 alongProbe(const FreeSpace& space, const glm::dvec3& normalGrid, const Probe& probe) {
  return glm::transpose(rotationMatrix(probe.rotationDegrees)) * (space.worldFromGrid * normalGrid);
}

/// The sides of a box along a probe's axes on which its room is open to one of the other kind, indoors or outdoors,
/// moved in to where that begins.
Box keptApart(const Rooms& rooms, std::size_t room, const Probe& probe, Box along) {
  for (const Doorway& doorway : rooms.doorways) {
    if (doorway.a != room && doorway.b != room) continue;
    if (rooms.rooms[doorway.a].outdoors == rooms.rooms[doorway.b].outdoors) continue;
    const glm::dvec3 out = alongProbe(rooms.space, doorway.a == room ? doorway.normal : -doorway.normal, probe);
    const glm::dvec3 size = glm::abs(out);
    const int axis = size.x > std::max(size.y, size.z) ? 0 : size.y > size.z ? 1 : 2;
    if (size[axis] < 0.8) continue;  // around a corner: no side of a box is there
    const Box extent = extentOf(rooms.space, rooms.rooms[room].cells, rotationMatrix(probe.rotationDegrees));
    if (out[axis] > 0.0) {
      along.max[axis] = std::min(along.max[axis], extent.max[axis]);
    } else {
      along.min[axis] = std::max(along.min[axis], extent.min[axis]);
    }
  }
  return along;
}

}  // namespace

void keepApart(const Rooms& rooms, std::size_t room, Probe& probe) {
  const Box before = alongAxes(probe.box, probe), along = keptApart(rooms, room, probe, before);
  if (along == before) return;
  const glm::dvec3 middle = rotationMatrix(probe.rotationDegrees) * along.center(), half = 0.5 * along.size();
  probe.box = {middle - half, middle + half};
}

void setBoxAbout(Probe& probe, const FreeSpace& space, const std::vector<std::size_t>& cells,
                 const glm::dvec3& rotationDegrees) {
  const glm::dmat3 worldFromAxes = rotationMatrix(rotationDegrees);
  const Box extent = extentOf(space, cells, worldFromAxes);
  probe.rotationDegrees = rotationDegrees;
  const glm::dvec3 middle = worldFromAxes * extent.center(), half = 0.5 * extent.size() + 0.5 * space.cell;
  probe.box = {middle - half, middle + half};
  probe.influence = Box{probe.box.min - 0.5 * space.cell, probe.box.max + 0.5 * space.cell};
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
}

namespace {

/// How far behind each wall lie the frames, panes and reveals that the room sees there: per axis, below and above; 0
/// where there are none, or another room is behind the wall.
std::array<glm::dvec3, 2> surfacesBehind(const SurfaceRays& rays, const Rooms& rooms, std::size_t room,
                                         const Probe& probe, const Box& walls) {
  constexpr std::size_t kLooks = 250, kLeast = 3;
  constexpr int kDirections = 48;
  const FreeSpace& space = rooms.space;
  const double skin = kSkin * rooms.region.height, most = kMostGap * rooms.region.height;
  const glm::dmat3 axesFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  std::vector<double> depths[2][3];
  const auto behind = [&](const glm::dvec3& p, int axis, bool upper) {
    for (int other = 0; other < 3; ++other) {
      if (other != axis && (p[other] < walls.min[other] || p[other] > walls.max[other])) return 0.0;
    }
    return upper ? p[axis] - walls.max[axis] : walls.min[axis] - p[axis];
  };
  const std::vector<std::size_t>& cells = rooms.rooms[room].cells;
  const std::vector<glm::dvec3> directions = fibonacciDirections(kDirections, 0.61);
  const std::size_t stride = std::max<std::size_t>(1, cells.size() / kLooks);
  for (std::size_t i = 0; i < cells.size(); i += stride) {
    const glm::dvec3 from = space.worldPosition(cells[i]);
    for (const glm::dvec3& along : directions) {
      const std::optional<SurfaceHit> hit = rays.first(from, along);
      if (!hit) continue;
      const glm::dvec3 p = axesFromWorld * (from + hit->distance * along);
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
          const double depth = behind(p, axis, upper);
          if (depth > 0.5 * skin && depth <= most) depths[upper ? 1 : 0][axis].push_back(depth);
        }
      }
    }
  }
  std::array<glm::dvec3, 2> reach{glm::dvec3(0.0), glm::dvec3(0.0)};
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      std::vector<double>& found = depths[upper ? 1 : 0][axis];
      if (found.size() < kLeast) continue;
      double& to = reach[upper ? 1 : 0][axis];
      to = *std::max_element(found.begin(), found.end());
      for (std::size_t other = 0; other < rooms.rooms.size() && to > 0.0; ++other) {
        if (other == room) continue;
        for (const std::size_t cell : rooms.rooms[other].cells) {
          const double depth = behind(axesFromWorld * space.worldPosition(cell), axis, upper);
          if (depth > 0.0 && depth <= to + space.cell) to = 0.0;
        }
      }
    }
  }
  return reach;
}

}  // namespace

void setInfluences(const SurfaceRays& rays, const Rooms& rooms, std::vector<PlacedProbe>& probes) {
  const FreeSpace& space = rooms.space;
  const double skin = kSkin * rooms.region.height;
  std::vector<Box> walls;
  for (PlacedProbe& placed : probes) {
    keepApart(rooms, placed.room, placed.probe);
    const Box found = wallsOf(rays, space, rooms.rooms[placed.room].cells, placed.probe);
    walls.push_back(keptApart(rooms, placed.room, placed.probe, found));
  }
  for (std::size_t i = 0; i < probes.size(); ++i) {
    Probe& probe = probes[i].probe;
    BlendDistance reach{glm::dvec3(skin), glm::dvec3(skin)};
    const std::array<glm::dvec3, 2> surfaces = surfacesBehind(rays, rooms, probes[i].room, probe, walls[i]);
    for (const Doorway& doorway : rooms.doorways) {
      if (doorway.a != probes[i].room && doorway.b != probes[i].room) continue;
      const bool here = doorway.a == probes[i].room;
      const std::size_t otherRoom = here ? doorway.b : doorway.a;
      const auto other = std::find_if(probes.begin(), probes.end(),
                                      [otherRoom](const PlacedProbe& each) { return each.room == otherRoom; });
      if (other == probes.end() || other->probe.rotationDegrees != probe.rotationDegrees) continue;
      const glm::dvec3 out = alongProbe(space, here ? doorway.normal : -doorway.normal, probe);
      const int axis = std::abs(out.x) > std::abs(out.z) ? 0 : 2;
      const bool upper = out[axis] > 0.0;
      const Box& there = walls[static_cast<std::size_t>(other - probes.begin())];
      const double gap = (upper ? 1.0 : -1.0) * (side(there, axis, !upper) - side(walls[i], axis, upper));
      if (gap <= skin || gap > kMostGap * rooms.region.height) continue;
      double& to = (upper ? reach.max : reach.min)[axis];
      to = std::max(to, gap);
    }
    probe.blendDistance = reach;
    // Surfaces behind a wall have the full weight; through a door one probe fades into the next.
    const auto add = [skin](double& to, double behind) { to = to > skin ? to : behind + skin; };
    for (int axis = 0; axis < 3; ++axis) {
      add(reach.min[axis], surfaces[0][axis]);
      add(reach.max[axis], surfaces[1][axis]);
    }
    probe.influence = asOfProbe({walls[i].min - reach.min, walls[i].max + reach.max}, probe);
  }
}

void setPartInfluence(const SurfaceRays& rays, const FreeSpace& space, const std::vector<std::size_t>& cells,
                      const Probe& ofRoom, Probe& ofPart) {
  const Box walls = wallsOf(rays, space, cells, ofPart);
  const Box whole = alongAxes(ofRoom.influenceBox(), ofRoom);
  const bool sameAxes = ofRoom.rotationDegrees == ofPart.rotationDegrees;
  Box influence = walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      double& to = (upper ? influence.max : influence.min)[axis];
      double& blend = (upper ? ofPart.blendDistance.max : ofPart.blendDistance.min)[axis];
      if (sameAxes && std::abs(to - side(whole, axis, upper)) <= 2.0 * space.cell) {
        to = side(whole, axis, upper);
        blend = (upper ? ofRoom.blendDistance.max : ofRoom.blendDistance.min)[axis];
      } else {
        blend = 3.0 * space.cell;
        to += (upper ? 0.5 : -0.5) * blend;
      }
    }
  }
  ofPart.influence = asOfProbe(influence, ofPart);
  ofPart.importance = ofRoom.importance + 1.0;
}

namespace {

double volumeOf(const Box& box) {
  const glm::dvec3 size = glm::max(box.size(), glm::dvec3(0.0));
  return size.x * size.y * size.z;
}

/// The influence box of `other` along the axes of `probe`: its bounds, if it is rotated otherwise.
Box influenceAlong(const Probe& probe, const Probe& other) {
  if (other.rotationDegrees == probe.rotationDegrees) return alongAxes(other.influenceBox(), other);
  Probe turned = other;
  const Box upright = influenceBounds(other);
  turned.rotationDegrees = probe.rotationDegrees;
  return alongAxes(turnedInfluence(upright, turned), turned);
}

}  // namespace

double influenceDistance(const Probe& probe, const glm::dvec3& world) {
  const Box box = alongAxes(probe.influenceBox(), probe);
  const glm::dvec3 p = glm::transpose(rotationMatrix(probe.rotationDegrees)) * world;
  return glm::length(glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0.0)));
}

void reachOver(Probe& probe, const glm::dvec3& world, double skin) {
  Box box = alongAxes(probe.influenceBox(), probe);
  const glm::dvec3 p = glm::transpose(rotationMatrix(probe.rotationDegrees)) * world;
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.min[axis] + skin) {
      box.min[axis] = std::min(box.min[axis], p[axis] - 2.0 * skin);
      probe.blendDistance.min[axis] = std::min(probe.blendDistance.min[axis], skin);
    }
    if (p[axis] > box.max[axis] - skin) {
      box.max[axis] = std::max(box.max[axis], p[axis] + 2.0 * skin);
      probe.blendDistance.max[axis] = std::min(probe.blendDistance.max[axis], skin);
    }
  }
  probe.influence = asOfProbe(box, probe);
}

double sharedVolume(const Probe& a, const Probe& b) {
  const Box first = alongAxes(a.influenceBox(), a), second = influenceAlong(a, b);
  return volumeOf({glm::max(first.min, second.min), glm::min(first.max, second.max)});
}

std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<PlacedProbe>& probes) {
  constexpr double kOverlap = 0.05;  // of the smaller volume
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (std::size_t k = i + 1; k < probes.size(); ++k) {
      const double a = volumeOf(probes[i].probe.influenceBox());
      const double b = volumeOf(influenceAlong(probes[i].probe, probes[k].probe));
      if (sharedVolume(probes[i].probe, probes[k].probe) > kOverlap * std::min(a, b)) pairs.emplace_back(i, k);
    }
  }
  return pairs;
}

}  // namespace boxprobe
