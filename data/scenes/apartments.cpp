// Apartments by the dozen: modules of four rooms at a corridor, stacked and set side by side, as many as asked for.
// Every room has its probe and so has every corridor; the first module is the same whatever their number, so a view
// from inside it shows the same picture and everything beyond its walls is what a renderer may leave out.
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <string>

#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

// Metres. A room's own frame: the door wall lies in z = 0 about x = 0, the room behind it towards +z.
constexpr double kRoomWidth = 3.9, kRoomDepth = 4.0, kHeight = 2.8, kWall = 0.1, kCorridor = 2.0;
constexpr double kPitch = kRoomWidth + kWall, kLength = 2.0 * kPitch - kWall;
constexpr double kDoorWidth = 1.0, kDoorHeight = 2.1;
// From module to module: gaps of 2 dm, so that no two of them share a plane.
const glm::dvec3 kModulePitch(kLength + 0.3, kHeight + 0.3, kCorridor + 2.0 * (kWall + kRoomDepth) + 0.3);
constexpr int kAcross = 8, kStoreys = 4;
constexpr int kWallPictures = 6, kFloors = 3;
constexpr double kSkin = 0.05;  // of influence boxes beyond the walls: less than half a wall
constexpr double kDoorBlend = kWall;
constexpr float kFloorGlow = 0.12f;  // in a first capture a mirror would be black

/// Fractions of `length` at which a wall is cut for doors about the given middles.
std::vector<double> doorCuts(double length, const std::vector<double>& middles) {
  std::vector<double> cuts = {0.0};
  for (const double middle : middles) {
    cuts.push_back((middle - 0.5 * kDoorWidth) / length);
    cuts.push_back((middle + 0.5 * kDoorWidth) / length);
  }
  cuts.push_back(1.0);
  return cuts;
}

const std::vector<double> kDoorRows = {0.0, kDoorHeight / kHeight, 1.0};

/// Every second column of the lower row is a door.
bool notDoor(int column, int row) {
  return row > 0 || column % 2 == 0;
}

MeshBuilder roomShell() {
  const double w = kRoomWidth, h = kHeight, d = kRoomDepth, x = 0.5 * w, door = 0.5 * kDoorWidth;
  MeshBuilder mesh;
  mesh.quadGrid({-x, 0, 0}, {w, 0, 0}, {0, h, 0}, doorCuts(w, {x}), kDoorRows, {}, notDoor);
  mesh.quad({x, 0, d}, {-w, 0, 0}, {0, h, 0});
  mesh.quad({-x, 0, d}, {0, 0, -d}, {0, h, 0});
  mesh.quad({x, 0, 0}, {0, 0, d}, {0, h, 0});
  mesh.quad({-x, h, 0}, {w, 0, 0}, {0, 0, d}, {0.45, 0.05, 0.55, 0.1});
  // The door's frame, through the wall.
  const UvRectangle plain{0.45, 0.05, 0.55, 0.1};
  mesh.quad({-door, 0, 0}, {0, 0, -kWall}, {0, kDoorHeight, 0}, plain);
  mesh.quad({door, 0, -kWall}, {0, 0, kWall}, {0, kDoorHeight, 0}, plain);
  mesh.quad({-door, kDoorHeight, -kWall}, {kDoorWidth, 0, 0}, {0, 0, kWall}, plain);
  return mesh;
}

MeshBuilder roomFloor() {
  const double x = 0.5 * kRoomWidth, door = 0.5 * kDoorWidth;
  MeshBuilder mesh;
  mesh.quadGrid({-x, 0, kRoomDepth}, {kRoomWidth, 0, 0}, {0, 0, -kRoomDepth}, doorCuts(kRoomWidth, {x}), {0.0, 1.0});
  mesh.quad({-door, 0, 0}, {kDoorWidth, 0, 0}, {0, 0, -kWall});
  return mesh;
}

/// Its own frame: x from 0 to its length, the middle in z = 0.
MeshBuilder corridorShell() {
  const double z = 0.5 * kCorridor, h = kHeight, l = kLength;
  const double first = 0.5 * kRoomWidth, second = first + kPitch;
  MeshBuilder mesh;
  mesh.quadGrid({0, 0, -z}, {l, 0, 0}, {0, h, 0}, doorCuts(l, {first, second}), kDoorRows, {}, notDoor);
  mesh.quadGrid({l, 0, z}, {-l, 0, 0}, {0, h, 0}, doorCuts(l, {l - second, l - first}), kDoorRows, {}, notDoor);
  mesh.quad({0, 0, z}, {0, 0, -kCorridor}, {0, h, 0}, {0.0, 0.0, 0.25, 1.0});
  mesh.quad({l, 0, -z}, {0, 0, kCorridor}, {0, h, 0}, {0.0, 0.0, 0.25, 1.0});
  mesh.quad({0, h, -z}, {l, 0, 0}, {0, 0, kCorridor}, {0.45, 0.05, 0.55, 0.1});
  return mesh;
}

MeshBuilder corridorFloor() {
  MeshBuilder mesh;
  mesh.quad({0, 0, 0.5 * kCorridor}, {kLength, 0, 0}, {0, 0, -kCorridor});
  return mesh;
}

MeshBuilder ceilingLamp(double width, double depth) {
  MeshBuilder mesh;
  mesh.quad({-0.5 * width, kHeight - 0.01, -0.5 * depth}, {width, 0, 0}, {0, 0, depth});
  return mesh;
}

MeshBuilder table() {
  MeshBuilder mesh;
  mesh.box({-0.6, 0.68, -0.4}, {0.6, 0.74, 0.4}, repeating(1.0));
  for (const double x : {-0.55, 0.49}) {
    for (const double z : {-0.35, 0.29}) mesh.box({x, 0.0, z}, {x + 0.06, 0.68, z + 0.06}, repeating(1.0));
  }
  return mesh;
}

Picture wallPicture(int index) {
  const glm::dvec3 colors[kWallPictures][2] = {
      {{0.72, 0.33, 0.20}, {0.90, 0.78, 0.55}}, {{0.16, 0.36, 0.62}, {0.75, 0.84, 0.92}},
      {{0.22, 0.48, 0.24}, {0.86, 0.88, 0.60}}, {{0.55, 0.22, 0.46}, {0.92, 0.74, 0.82}},
      {{0.80, 0.60, 0.15}, {0.30, 0.24, 0.20}}, {{0.14, 0.50, 0.52}, {0.92, 0.90, 0.84}}};
  return paint("wall " + std::to_string(index + 1), 256, 128, [=](double u, double v) {
    const glm::dvec3 paper = colors[index][1] * (0.75 + 0.1 * noise(24.0 * u, 12.0 * v, 24, 12, index));
    if (v < 0.12) return paper;  // the ceiling's and the door frames' part, too
    const double stripes = softLines(u, 0.125, 0.02 + 0.004 * index, 0.008);
    const double panel = softStep(0.62, 0.012, v);
    return blend(blend(paper, colors[index][0], 0.7 * stripes), colors[index][0], panel);
  });
}

double drawn(int module, int room, int what, unsigned seed) {
  return hash(16 * module + room, what, static_cast<int>(seed));
}

Probe makeProbe(const std::string& name, const Box& box, const glm::dvec3& origin) {
  Probe probe;
  probe.name = name;
  probe.origin = origin;
  probe.box = box;
  probe.farDistance = 12.0;  // the corridor and a room behind it: what a probe can see at all
  probe.faceSize = 128;
  return probe;
}

struct Parts {
  int shells[kWallPictures], floors[kFloors], corridor, corridorFloor, lamp, corridorLamp, ball, table;
};

Parts makeParts(Composer& model) {
  Parts parts{};
  for (int i = 0; i < kWallPictures; ++i) {
    const std::string name = "wall " + std::to_string(i + 1);
    parts.shells[i] = model.mesh(roomShell(), name, model.material(lit(name, wallPicture(i), 0.55f)));
  }
  const float roughness[kFloors] = {0.0f, 0.12f, 0.3f};
  for (int i = 0; i < kFloors; ++i) {
    Material floor = perfectMirror("floor " + std::to_string(i + 1));
    floor.baseColor = glm::vec4(0.85f, 0.82f, 0.78f, 1.0f);
    floor.roughness = roughness[i];
    floor.emissive = kFloorGlow * glm::vec3(floor.baseColor);
    parts.floors[i] = model.mesh(roomFloor(), floor.name, model.material(floor));
  }
  parts.corridor =
      model.mesh(corridorShell(), "corridor", model.material(lit("corridor", wallPicture(kWallPictures - 1), 0.5f)));
  Material tiles = perfectMirror("corridor floor");
  tiles.baseColor = glm::vec4(0.8f, 0.8f, 0.82f, 1.0f);
  tiles.roughness = 0.08f;
  tiles.emissive = kFloorGlow * glm::vec3(tiles.baseColor);
  parts.corridorFloor = model.mesh(corridorFloor(), tiles.name, model.material(tiles));
  const int light = model.material(lamp("lamp", glm::vec3(9.0f, 8.4f, 7.4f)));
  parts.lamp = model.mesh(ceilingLamp(1.4, 0.5), "lamp", light);
  parts.corridorLamp = model.mesh(ceilingLamp(5.0, 0.2), "corridor lamp", light);
  parts.ball = model.mesh(sphere(1.0, 48), "sphere", model.material(perfectMirror("sphere")));
  parts.table = model.mesh(table(), "table", model.material(lit("wood", {0.45, 0.28, 0.14}, 0.3f)));
  return parts;
}

void addRoom(Composer& model, Scene& scene, const Parts& parts, int number, int module, int room, unsigned seed,
             const glm::dvec3& corner) {
  const auto pick = [&](int what) { return drawn(module, room, what, seed); };
  const bool north = room >= 2;
  const double side = north ? -1.0 : 1.0;
  const glm::dvec3 door =
      corner + glm::dvec3(0.5 * kRoomWidth + (room % 2) * kPitch, 0.0, side * (0.5 * kCorridor + kWall));
  glm::dmat4 worldFromRoom = glm::translate(glm::dmat4(1.0), door);
  // The rooms on the other side of the corridor are turned, not mirrored.
  if (north) worldFromRoom *= glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
  const auto at = [&](double x, double y, double z) {
    return door + side * glm::dvec3(x, 0.0, z) + glm::dvec3(0, y, 0);
  };
  const std::string name = "room " + std::to_string(number);
  model.place(name + " walls", parts.shells[static_cast<int>(pick(0) * kWallPictures)], worldFromRoom);
  model.place(name + " floor", parts.floors[static_cast<int>(pick(1) * kFloors)], worldFromRoom);
  const double radius = 0.25 + 0.2 * pick(2);
  model.place(name + " sphere", parts.ball, at(1.3 - 0.5 * pick(3), radius, 0.8 + 0.8 * pick(4)), radius);
  model.place(name + " table", parts.table, at(-0.9 + 0.5 * pick(5), 0.0, 2.6 + 0.7 * pick(6)));
  model.place(name + " lamp", parts.lamp, at(0.0, 0.0, 0.5 * kRoomDepth));
  scene.objects[name + " sphere"].seenByProbes = false;

  const glm::dvec3 a = at(-0.5 * kRoomWidth, 0.0, 0.0), b = at(0.5 * kRoomWidth, kHeight, kRoomDepth);
  const Box inner{glm::min(a, b) - 0.005, glm::max(a, b) + 0.005};
  Probe probe = makeProbe(name, inner, at(0.2, 1.3, 1.8));
  Box influence{inner.min - (kSkin - 0.005), inner.max + (kSkin - 0.005)};
  probe.blendDistance = BlendDistance{glm::dvec3(kSkin - 0.005), glm::dvec3(kSkin - 0.005)};
  // Through the whole of the door's frame, where the corridor's probe gives way to it.
  (north ? influence.max : influence.min).z -= side * (2.0 * kWall - kSkin);
  (north ? probe.blendDistance.max : probe.blendDistance.min).z = kDoorBlend;
  probe.influence = influence;
  scene.probes.push_back(std::move(probe));
}

void addModule(Composer& model, Scene& scene, const Parts& parts, int module, int rooms, unsigned seed) {
  const glm::dvec3 cell(module % kAcross, module / kAcross % kStoreys, module / (kAcross * kStoreys));
  const glm::dvec3 corner = cell * kModulePitch;
  const std::string name = "corridor " + std::to_string(module + 1);
  model.place(name + " walls", parts.corridor, corner);
  model.place(name + " floor", parts.corridorFloor, corner);
  model.place(name + " lamp", parts.corridorLamp, corner + glm::dvec3(0.5 * kLength, 0.0, 0.0));
  const Box inner{corner + glm::dvec3(-0.005, -0.005, -0.5 * kCorridor - 0.005),
                  corner + glm::dvec3(kLength + 0.005, kHeight + 0.005, 0.5 * kCorridor + 0.005)};
  Probe probe = makeProbe(name, inner, corner + glm::dvec3(0.5 * kLength, 1.4, 0.0));
  const glm::dvec3 reach(kSkin - 0.005, kSkin - 0.005, kWall);
  probe.influence = Box{inner.min - reach, inner.max + reach};
  probe.blendDistance = BlendDistance{reach, reach};
  probe.importance = 2.0;  // where a room's influence reaches into the corridor, the corridor counts
  scene.probes.push_back(std::move(probe));
  for (int room = 0; room < rooms; ++room)
    addRoom(model, scene, parts, 4 * module + room + 1, module, room, seed, corner);
}

Camera camera(const std::string& name, const glm::dvec3& position, const glm::dvec3& target) {
  Camera result;
  result.name = name;
  result.position = position;
  result.target = target;
  result.verticalFovDegrees = 65.0;
  return result;
}

}  // namespace

Apartments apartments(int rooms, unsigned seed) {
  Composer model;
  Apartments result;
  const Parts parts = makeParts(model);
  for (int module = 0; 4 * module < rooms; ++module) {
    addModule(model, result.scene, parts, module, std::min(4, rooms - 4 * module), seed);
  }
  result.scene.sky = SkyColor{glm::vec3(0.35f, 0.45f, 0.6f)};
  result.scene.cameras = {camera("main", {0.9, 1.7, 4.7}, {2.2, 0.75, 1.0}),
                          camera("corridor", {0.4, 1.6, 0.3}, {7.0, 0.8, -0.2})};
  result.model = std::move(model).finish();
  return result;
}

}  // namespace boxprobe::scenes
