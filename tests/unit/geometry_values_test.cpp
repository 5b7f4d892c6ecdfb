// What is derived of the geometry of a house without tracing through it, against geometry_values.txt: its lamps and
// polygons, who draws them, mirrors, places and weights of probes, pieces of models.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>

#include "filters/core/geometry/box_tree.h"
#include "filters/core/geometry/divide_model.h"
#include "filters/core/geometry/flat_polygons.h"
#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/light_shadow.h"
#include "filters/core/geometry/mirror_plane.h"
#include "filters/core/geometry/mirror_view.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/probe_at.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/core/picture/cube_picture.h"
#include "filters/core/picture/pareto_front.h"
#include "filters/core/picture/probe_color.h"
#include "tests/support/kept_values.h"
#include "tests/support/sphere_mesh.h"
#include "tests/unit/geometry_house.h"

namespace boxprobe::test {
namespace {

using Lines = std::vector<std::string>;
using glm::dvec3;

std::string listText(const std::vector<std::size_t>& list) {
  std::string text;
  for (const std::size_t i : list) text += " " + std::to_string(i);
  return text.empty() ? " none" : text;
}

void addPolygon(Lines& lines, const std::vector<dvec3>& corners) {
  std::string text = " ";
  for (const dvec3& corner : corners) text += " (" + keptVector(corner) + ")";
  lines.push_back(text);
}

void addLamps(Lines& lines) {
  const House house;
  const Scene scene = house.scene();
  const SceneLamps lamps = sceneLamps(scene, {house.model()});
  lines.emplace_back("== lamps");
  for (const SceneLamp& lamp : lamps.lamps) {
    lines.push_back(lamp.node + " of " + lamp.material + " at " + keptVector(lamp.middle) + " towards " +
                    keptVector(lamp.normal) + ", " + keptVector(lamp.radiance) + (lamp.bothSides ? " both" : "") +
                    ", area " + keptNumber(lamp.area) + " power " + keptNumber(lamp.power) + " group " +
                    std::to_string(lamp.group) + (lamp.light ? " light " + std::to_string(*lamp.light) : ""));
    addPolygon(lines, lamp.corners);
    const LampPolygon polygon = lampPolygon(lamp, {0.4, 0.7, -0.3}, rotationMatrix({11.0, 22.0, 33.0}));
    lines.push_back("  turned " + std::to_string(polygon.count) + (polygon.bothSides ? " both" : "") + ": " +
                    keptVector(polygon.corners[0]) + ", " + keptVector(polygon.corners[2]));
  }
  for (const std::string& remark : lamps.remarks) lines.push_back(remark);
  for (const Probe& probe : scene.probes) {
    for (const std::size_t most : {2, 5, 8, 16}) {
      lines.push_back(probe.name + " draws of " + std::to_string(most) + ":" +
                      listText(probeLamps(lamps.lamps, probe, most)) + ", captured" +
                      listText(captureLamps(lamps.lamps, probe, most)));
    }
    const auto addTask = [&](const SightTask& task) {
      lines.push_back("  task " + keptBox(task.box) + " by " + keptVector(task.rotationDegrees) + " reach " +
                      keptVector(task.reach.low) + " and " + keptVector(task.reach.high) +
                      (task.from ? " from " + keptVector(*task.from) : "") + ", own " + std::to_string(task.own));
      for (const SightTask::Lamp& lamp : task.lamps) {
        lines.push_back("    lamp " + std::to_string(lamp.index) + " " + keptVector(lamp.corners[1]) + " " +
                        keptVector(lamp.normal) + (lamp.bothSides ? " both" : ""));
      }
      for (const SightTask::Source& source : task.sources) {
        lines.push_back("    source " + std::to_string(source.index) + " " + keptVector(source.position) + " " +
                        keptNumber(source.radius));
      }
    };
    addTask(sightTask(scene, lamps, probe));
    addTask(captureSightTask(scene, lamps, probe));
    const ProbeSight untraced = untracedSight(lamps, probe);
    lines.push_back("  untraced" + listText(untraced.lamps) + ", channels " +
                    std::to_string(untraced.lampChannel.size()) + " of " + std::to_string(untraced.channelOfLamp(0)) +
                    ", " + std::to_string(untraced.channelOfLamp(99)));
  }
  for (const dvec3& size : {dvec3(5.0, 2.6, 4.1), dvec3(41.0, 3.0, 17.0), dvec3(0.3, 0.2, 0.1), dvec3(0.0, 0.0, 0.0),
                            dvec3(1e9, 1e300, 3.0), dvec3(7.0, 0.0, 2.0)}) {
    const glm::ivec3 a = sightNodes(size), b = sightNodes(size, {0.7, 500});
    lines.push_back("nodes " + std::to_string(a.x) + " " + std::to_string(a.y) + " " + std::to_string(a.z) +
                    ", fewer " + std::to_string(b.x) + " " + std::to_string(b.y) + " " + std::to_string(b.z));
  }
}

void addPolygons(Lines& lines) {
  // A plate of 3 x 4 squares with a hole and a notch, a flap that stands off it, its back side, and waste.
  std::vector<dvec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto quad = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c, d});
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  };
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if ((row == 1 && column == 1) || (row == 2 && column == 3)) continue;
      const double x = 0.7 * column, y = 0.4 * row;
      quad({x, y, 0.0}, {x + 0.7, y, 0.0}, {x + 0.7, y + 0.4, 0.0}, {x, y + 0.4, 0.0});
    }
  }
  quad({0.0, 0.0, 0.0}, {0.0, 0.4, 0.0}, {-0.5, 0.4, 0.3}, {-0.5, 0.0, 0.3});
  quad({5.0, 0.0, 1.0}, {5.0, 1.0, 1.0}, {6.0, 1.0, 1.0}, {6.0, 0.0, 1.0});
  quad({5.0, 0.0, 1.0}, {6.0, 0.0, 1.0}, {6.0, 1.0, 1.0}, {5.0, 1.0, 1.0});
  triangles.push_back({0, 1, 2});  // repeated
  triangles.push_back({3, 3, 7});
  lines.emplace_back("== flat polygons");
  for (const FlatPolygon& polygon : flatPolygons(positions, triangles)) {
    lines.push_back("polygon of " + std::to_string(polygon.component) + ", area vector " +
                    keptVector(areaVector(polygon.corners)) + " about " + keptVector(polygonCentroid(polygon.corners)));
    addPolygon(lines, polygon.corners);
  }
  std::vector<dvec3> rim;
  for (int i = 0; i < 17; ++i) {
    const double a = 6.283185307 * i / 17.0;
    rim.emplace_back(1.3 * std::cos(a), 0.2 + 0.1 * std::cos(a), 0.8 * std::sin(a));
  }
  for (const std::size_t most : {17, 11, 8, 5, 3}) {
    lines.push_back("at most " + std::to_string(most) + ": " + keptVector(areaVector(withFewerCorners(rim, most))));
    addPolygon(lines, withFewerCorners(rim, most));
  }
}

std::string matrixText(const glm::dmat4& m) {
  std::string text;
  for (int column = 0; column < 4; ++column) text += " (" + keptVector(m[column]) + " " + keptNumber(m[column].w) + ")";
  return text;
}

void addPlacement(Lines& lines) {
  lines.emplace_back("== placement");
  ModelFile file;
  file.translation = {1.3, -0.7, 2.9};
  file.rotationDegrees = {12.0, -37.0, 61.0};
  file.scale = 1.7;
  for (const LengthUnit unit :
       {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre, LengthUnit::Inch, LengthUnit::Foot}) {
    file.unit = unit;
    lines.push_back("unit " + keptNumber(metresPerUnit(unit)) + matrixText(worldFromFile(file)));
  }
  file.unit = LengthUnit::Inch;
  for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
    file.upAxis = up;
    lines.push_back("up " + std::to_string(static_cast<int>(up)) + matrixText(worldFromFile(file)));
  }
  Model model;
  Light light;
  light.type = LightType::Spot;
  light.position = {0.3, 1.2, -0.8};
  light.direction = {0.1, -0.9, 0.4};
  light.intensity = 3.0f;
  light.range = 7.0;
  light.radius = 0.11;
  model.lights = {light};
  Camera camera;
  camera.position = {0.2, 3.3, 1.7};
  camera.target = {1.2, 0.3, -0.7};
  camera.up = {0.1, 0.8, 0.3};
  camera.parallelHeight = 2.3;
  model.cameras = {camera};
  const Light lit = placedLights(model, file).at(0);
  lines.push_back("light " + keptVector(lit.position) + " " + keptVector(lit.direction) + " " +
                  keptNumber(lit.intensity) + " " + keptNumber(lit.range) + " " + keptNumber(lit.radius));
  const Camera seen = placedCameras(model, file).at(0);
  lines.push_back("camera " + keptVector(seen.position) + " " + keptVector(seen.target) + " " + keptVector(seen.up) +
                  " " + keptNumber(seen.parallelHeight) + " " + keptNumber(seen.verticalFovDegrees));
  ObjectOverride moved;
  moved.translation = {0.4, 0.5, -0.6};
  moved.rotationDegrees = {21.0, -8.0, 35.0};
  lines.push_back("moved" + matrixText(movedInstance(worldFromFile(file), moved)));
  for (const dvec3& degrees : {dvec3(12.0, -37.0, 61.0), dvec3(170.0, 100.0, -20.0), dvec3(30.0, 90.0, 0.0)}) {
    lines.push_back("angles " + keptVector(rotationDegreesOf(rotationMatrix(degrees))) + ", " +
                    keptNumber(wrappedDegrees(3.0 * degrees.x)));
  }
}

void addMirrors(Lines& lines) {
  lines.emplace_back("== mirrors");
  Scene scene;
  scene.models.push_back({"pane.glb"});
  scene.models[0].rotationDegrees = {7.0, 21.0, -13.0};
  scene.models[0].translation = {0.3, -0.2, 0.5};
  scene.objects["pane"].translation = {0.1, 0.2, 0.3};
  auto model = std::make_shared<Model>();
  Mesh pane, wedge;
  pane.positions = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {4, 1, 0}};
  pane.indices = {0, 1, 2, 0, 2, 3, 1, 4, 2};
  wedge.positions = {{0, 0, 0}, {2.0f, 0.3f, 0}, {0.4f, 1.1f, 0}};
  wedge.indices = {0, 1, 2};
  pane.material = 0;
  model->materials.emplace_back();
  model->materials[0].doubleSided = true;
  model->meshes = {pane, wedge};
  model->instances = {{"pane", 0, glm::dmat4(1.0)}, {"wedge", 1, glm::dmat4(1.0)}};
  for (const std::string node : {"pane", "wedge"}) {
    const MirrorPlane plane = *mirrorPlane(scene, {model}, node);
    lines.push_back(node + " at " + keptVector(plane.center) + " towards " + keptVector(plane.normal) +
                    (plane.bothSides ? " both" : ""));
    addPolygon(lines, {plane.corners.begin(), plane.corners.end()});
    for (const bool parallel : {false, true}) {
      for (const double side : {1.0, -1.0}) {
        PictureView view;
        view.eye = plane.center + side * 2.3 * plane.normal + dvec3(0.7, 0.5, 0.3);
        view.forward = glm::normalize(plane.center + dvec3(0.9, 0.1, -0.2) - view.eye);
        view.up = glm::normalize(glm::cross(glm::cross(view.forward, dvec3(0.1, 1.0, 0.05)), view.forward));
        view.parallel = parallel;
        view.width = 900;
        view.height = 600;
        view.clipFromView =
            parallel ? glm::ortho(-1.5, 1.5, -1.0, 1.0, 0.1, 40.0) : glm::perspective(0.8, 1.5, 0.1, 40.0);
        MirrorPlane turned = plane;
        const bool faces = facesEye(turned, view);
        const std::vector<glm::dvec2> part = visiblePart(turned, view);
        std::string text = std::string(parallel ? "parallel" : "perspective") + (faces ? " faces " : " away ") +
                           keptVector(turned.normal) + ", " + keptNumber(areaOf(part, view)) + " pixels:";
        for (const glm::dvec2& p : part) text += " (" + keptNumber(p.x) + " " + keptNumber(p.y) + ")";
        lines.push_back(text);
        if (!faces || part.empty()) continue;
        const MirrorRect rect = mirroredRect(part, view, 5.0);
        const PictureView seen = mirroredView(turned, view, rect, 25.0);
        lines.push_back("  rect " + std::to_string(rect.x) + " " + std::to_string(rect.y) + " " +
                        std::to_string(rect.width) + " " + std::to_string(rect.height) + " from " +
                        keptVector(seen.eye) + " along " + keptVector(seen.forward) + " up " + keptVector(seen.up) +
                        matrixText(seen.clipFromView));
        lines.push_back("  view" + matrixText(seen.viewFromEye()) + " " + std::to_string(seen.width) + " x " +
                        std::to_string(seen.height));
      }
    }
  }
}

void addProbes(Lines& lines) {
  lines.emplace_back("== probes");
  Scene scene = House().scene();
  scene.probes[0].rotationDegrees = {3.0, -11.0, 5.0};
  Probe third = scene.probes[1];
  third.name = "third";
  third.influence = Box{{-3.1, -0.2, -4.4}, {1.5, 2.6, 0.4}};
  third.bevel = Bevel{0.2, 0.3};
  third.occlusion = BoxOcclusion{0.6, 0.7, 0.8};
  third.intensity = 1.3;
  third.technique = "godot";
  third.parameters["power"] = 2.5;
  scene.probes.push_back(third);
  for (const Probe& probe : scene.probes) {
    const ProbeGeometry g = probeGeometry(probe, probe.origin + dvec3(0.1, 0.2, 0.3), {4.0, 5.0, 6.0});
    lines.push_back(probe.name + " " + keptVector(g.boxMin) + " to " + keptVector(g.boxMax) + ", influence " +
                    keptVector(g.influenceMin) + " to " + keptVector(g.influenceMax) + ", rates " +
                    keptVector(g.rateMin) + " and " + keptVector(g.rateMax) + ", map" +
                    matrixText(glm::dmat4(g.mapFromProbe)) + ", world" + matrixText(glm::dmat4(g.worldFromProbe)));
    lines.push_back("  " + keptNumber(g.intensity) + " " + keptNumber(g.importance) + " bevel " +
                    keptNumber(g.bevelRadius) + " " + keptNumber(g.bevelFromRoughness) + " occlusion " +
                    keptVector(g.occlusion) + " " + techniqueId(g.technique) + " power " +
                    keptNumber(g.parameters.power) + ", shape " + keptNumber(probeShape(g, 6.0f, 0.4f).bevel));
    lines.push_back("  around " + keptBox(influenceBounds(probe)) + ", full " + keptBox(fullWeightBox(probe)));
    for (const BoxFace& face : kBoxFaces) {
      lines.push_back(std::string("  face ") + faceName(face) + " " + keptVector(faceCenterWorld(probe, face)) +
                      " along " + keptVector(faceAxisWorld(probe, face)) + ", moved " +
                      keptBox(withFaceMoved(probe.box, probe.rotationDegrees, face, 0.31, false, 0.05)) + ", both " +
                      keptBox(withFaceMoved(probe.box, probe.rotationDegrees, face, -0.27, true, 0.05)) + ", thin " +
                      keptBox(withFaceMoved(probe.box, probe.rotationDegrees, face, -99.0, false, 0.05)));
    }
    Probe other = probe;
    setBox(other, {{-1.0, 0.3, -2.0}, {1.5, 1.9, 0.7}});
    lines.push_back("  set " + keptBox(other.box) + ", influence " + keptBox(other.influenceBox()));
    addPolygon(lines, {boxCornersWorld(probe.box, rotationMatrix(probe.rotationDegrees), {0.1, 0.2, 0.3})[1],
                       boxCornersWorld(probe.box, rotationMatrix(probe.rotationDegrees), {0.1, 0.2, 0.3})[6]});
    for (const Box& object : {Box{{-1.0, 0.2, -3.4}, {0.4, 1.1, -2.7}}, Box{{1.2, 0.4, 1.0}, {3.9, 1.3, 2.2}},
                              Box{{-2.9, 0.4, -1.0}, {-1.9, 1.3, 0.2}}, Box{{-0.2, 0.9, -3.1}, {0.1, 1.2, -2.9}},
                              Box{{0.1, 1.0, 0.2}, {0.6, 1.6, 0.9}}, Box{{-0.6, 1.12, -3.18}, {-0.5, 1.25, -3.12}},
                              Box{{-0.6, 1.12, -3.18}, {0.9, 1.25, -3.12}}}) {
      lines.push_back("  weight " + keptNumber(objectWeight(probe, object)) +
                      (fullWeightEverywhere(probe, object) ? " full" : ""));
    }
    for (const Light& light : scene.lights) lines.back() += lightOutside(light, probe) ? " outside" : " inside";
  }
  const ProbeIndex index(scene.probes);
  for (const dvec3& place : {dvec3(0.3, 1.0, 1.0), dvec3(-1.0, 1.2, -2.4), dvec3(0.2, 1.0, -3.3), dvec3(2.4, 1.0, -2.3),
                             dvec3(9.0, 1.0, 4.0), dvec3(-2.2, 2.5, -4.1)}) {
    const auto one = [](const std::optional<std::size_t>& i) { return i ? std::to_string(*i) : std::string("none"); };
    lines.push_back("at " + keptVector(place) + " " + one(probeLighting(scene.probes, place)) + ", nearest " +
                    one(probeNearest(scene.probes, place)) + ", meeting" +
                    listText(index.meeting({place - 0.2, place + 0.3})));
  }
  for (const Light& light : scene.lights) {
    const LightSize size = lightSize(light);
    lines.push_back("light " + keptNumber(size.tangent) + " " + keptNumber(size.radius) + " " +
                    keptNumber(size.tangentAt(1.7f)));
  }
  lines.push_back("levels " + keptNumber(levelsPerUnit({-1.0f, -2.0f, -3.0f}, {2.0f, 1.5f, 1.0f}, 7.0f)));
  for (const bool only : {false, true}) {
    const ProbeShares shares = shareOut({0.4f, 0.9f, 0.3f, 0.2f}, {0, 1, 1, 2}, only);
    std::string text = "shares";
    for (const float share : shares.probes) text += " " + keptNumber(share);
    lines.push_back(text + " sky " + keptNumber(shares.sky));
  }
  std::vector<Box> boxes;
  for (int i = 0; i < 40; ++i) {
    const dvec3 low(i * 37 % 41, i * 17 % 23, i * 29 % 31);
    boxes.push_back({low, low + dvec3(1.0 + i % 3, 2.0, 0.5 + i % 5)});
  }
  const BoxTree tree(boxes);
  std::size_t deepest = 0, leaves = 0;
  for (const BoxTree::Node& node : tree.nodes()) {
    leaves += node.left < 0 ? 1u : 0u;
    deepest = std::max(deepest, static_cast<std::size_t>(node.left < 0 ? node.count : 0));
  }
  lines.push_back("tree of " + std::to_string(tree.nodes().size()) + " nodes, " + std::to_string(leaves) +
                  " leaves of up to " + std::to_string(deepest) + ", left " + keptBox(tree.nodes()[1].bounds));
}

void addPieces(Lines& lines) {
  lines.emplace_back("== pieces");
  Mesh egg = sphereMesh(1.0f, 7, 9);
  for (glm::vec3& p : egg.positions) p *= glm::vec3(1.4f, 0.9f, 1.1f);
  for (std::size_t i = 0; i < egg.positions.size(); ++i) {
    egg.tangents.emplace_back(egg.normals[i].z, 0.0f, -egg.normals[i].x, 1.0f);
    egg.uv1.push_back(1.7f * egg.uv[i]);
    egg.colors.emplace_back(egg.uv[i].x, egg.uv[i].y, 0.3f, 0.8f);
  }
  egg.material = 0;
  const glm::dmat4 at = movedInstance(glm::dmat4(1.0), [] {
    ObjectOverride moved;
    moved.rotationDegrees = {21.0, -8.0, 35.0};
    moved.translation = {0.4, 0.5, -0.6};
    return moved;
  }());
  const auto addMesh = [&](const std::string& name, const Mesh& mesh) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        numbers.insert(numbers.end(), {mesh.positions[i][c], mesh.normals[i][c], mesh.tangents[i][c]});
      }
      numbers.insert(numbers.end(), {mesh.tangents[i].w, mesh.uv[i].x, mesh.uv[i].y, mesh.uv1[i].x, mesh.uv1[i].y,
                                     mesh.colors[i].x, mesh.colors[i].y, mesh.colors[i].w});
    }
    lines.push_back(name + " " + std::to_string(mesh.indices.size()) + " indices, " + digest(numbers));
    std::vector<double> indices(mesh.indices.begin(), mesh.indices.end());
    lines.push_back("  indices " + digest(indices));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const MeshHalves halves = cutMesh(egg, at, axis, 0.37);
    addMesh("below " + std::to_string(axis), halves.below);
    addMesh("above " + std::to_string(axis), halves.above);
  }
  // A long floor with a probe every few metres.
  Mesh floor;
  for (int i = 0; i < 60; ++i) {
    const auto x = static_cast<float>(i);
    const auto first = static_cast<std::uint32_t>(floor.positions.size());
    floor.positions.insert(floor.positions.end(), {{x, 0, 0}, {x, 0, 4}, {x + 1, 0, 4}, {x + 1, 0, 0}});
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) floor.indices.push_back(first + k);
  }
  auto model = std::make_shared<Model>();
  model->meshes = {floor};
  model->instances = {{"floor", 0, glm::dmat4(1.0)}};
  std::vector<Probe> probes;
  for (int i = 0; i < 14; ++i) {
    Probe probe;
    probe.box = {{i * 4.3 - 0.7, -1.0, -1.0}, {i * 4.3 + 5.1 + i % 3, 3.0, 5.0}};
    probes.push_back(probe);
  }
  for (const std::size_t most : {3, 6, 20}) {
    const auto divided = dividedModel(model, glm::dmat4(1.0), probes, ProbeIndex(probes), most);
    std::string text = "at most " + std::to_string(most) + (divided == model ? " as it was:" : ":");
    for (const Instance& instance : divided->instances) {
      const Mesh& mesh = divided->meshes[static_cast<std::size_t>(instance.mesh)];
      text += " " + instance.node + " " + std::to_string(mesh.indices.size() / 3) + " from " +
              keptNumber(static_cast<double>(mesh.positions.front().x));
    }
    lines.push_back(text);
  }
}

void addPictures(Lines& lines) {
  lines.emplace_back("== pictures");
  CubeMap cube(8, 3);
  for (int level = 0; level < 3; ++level) {
    const int size = cube.levelSize(level);
    for (int i = 0; i < 6 * size * size; ++i) {
      const glm::vec4 value(0.02f * static_cast<float>(i * 37 % 61), 0.03f * static_cast<float>(i * 17 % 43),
                            0.05f * static_cast<float>(i % 29), 1.0f);
      cube.setTexel(level, i / (size * size), i % size, i / size % size, value);
    }
  }
  for (const CubePictureKind kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    for (const int width : {3, 21, 77, 130}) {
      const CubePicture picture(kind, width);
      lines.push_back("picture " + std::to_string(picture.width()) + " x " + std::to_string(picture.height()));
      for (int level = 0; level < 3; ++level) {
        const ImageRgba8 drawn = drawCubePicture(cube, level, picture, 0.7f, level == 1 ? Tone::Aces : Tone::None);
        for (std::size_t c = 0; c < 4; ++c) {
          std::vector<double> values;
          for (std::size_t i = c; i < drawn.pixels.size(); i += 4) values.push_back(drawn.pixels[i] / 255.0);
          lines.push_back("  level " + std::to_string(level) + " " + digest(values));
        }
      }
    }
    const CubePicture picture(kind, 120);
    for (const glm::vec3& d : {glm::vec3(1, 0.3f, 0.2f), glm::vec3(-2, 0.5f, 0.7f), glm::vec3(0.2f, 3, -0.4f),
                               glm::vec3(0.1f, -1, 0.6f), glm::vec3(0.3f, 0.2f, 1), glm::vec3(0.1f, -0.4f, -1)}) {
      const glm::dvec2 at = picture.position(d);
      const auto back = picture.direction(at);
      lines.push_back("  at " + keptNumber(at.x) + " " + keptNumber(at.y) + " back " +
                      (back ? keptVector(glm::normalize(*back)) : "none"));
    }
    for (const glm::dvec2& at : {glm::dvec2(3.0, 2.0), glm::dvec2(45.0, 4.0), glm::dvec2(119.9, 59.9),
                                 glm::dvec2(-1.0, 45.0), glm::dvec2(120.1, 45.0), glm::dvec2(50.0, 89.0)}) {
      const auto direction = picture.direction(at);
      lines.push_back("  along " + (direction ? keptVector(glm::normalize(*direction)) : "none"));
    }
    for (int face = 0; face < 6; ++face) {
      for (const int column : {0, 2, 3}) {
        std::string text = "  outline";
        for (const glm::dvec2& p : picture.texelOutline(4, face, column, 3 - face % 3)) {
          text += " " + keptNumber(p.x, 4) + " " + keptNumber(p.y, 4);
        }
        lines.push_back(text);
      }
    }
  }
  std::vector<ParetoPoint> points;
  for (const auto& [cost, error] :
       {std::pair(1.0, 0.5), {1.0, 0.5}, {2.0, 0.4}, {2.0, 0.6}, {3.0, 0.4}, {0.5, 0.9}, {4.0, 0.1}}) {
    ParetoPoint point;
    point.cost = cost;
    point.error = error;
    points.push_back(point);
  }
  markParetoFront(points);
  std::string front = "front";
  for (const ParetoPoint& point : points) front += point.onParetoFront ? " yes" : " no";
  lines.push_back(front);
  for (int i = 0; i < 9; ++i) lines.push_back("color " + keptVector(probeColor(i)));
}

TEST(GeometryValues, AreKept) {
  Lines lines;
  addLamps(lines);
  addPolygons(lines);
  addPlacement(lines);
  addMirrors(lines);
  addProbes(lines);
  addPieces(lines);
  addPictures(lines);
  test::expectKeptValues("unit/values/geometry_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
