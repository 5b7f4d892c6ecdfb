// What fits find in a house, step by step, against fit_values.txt and place_values.txt: rays, errors, planes, boxes,
// origins; rooms, influences, lights, cameras.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/box_gauge.h"
#include "filters/fit/box/fit_origin.h"
#include "filters/fit/box/place_check.h"
#include "filters/fit/exposure_key.h"
#include "filters/fit/fit_model.h"
#include "filters/fit/fitted_camera.h"
#include "filters/fit/place_eyes.h"
#include "filters/fit/place_influence.h"
#include "filters/fit/place_probes.h"
#include "filters/fit/rays/distance_rays.h"
#include "filters/fit/room_names.h"
#include "filters/fit/room_probe.h"
#include "filters/fit/standing_points.h"
#include "tests/support/distance_cube.h"
#include "tests/support/kept_values.h"
#include "tests/unit/geometry_house.h"

namespace boxprobe::test {
namespace {

using Lines = std::vector<std::string>;
using glm::dvec3;

/// The house's panels, in double precision, some of them smooth.
class HouseRays : public SurfaceRays {
 public:
  std::optional<SurfaceHit> first(const dvec3& origin, const dvec3& direction) const override {
    const auto met = house_.first(origin, direction);
    if (!met) return std::nullopt;
    SurfaceHit hit;
    hit.distance = met->distance;
    hit.back = met->back;
    hit.normalWorld = met->normal;
    hit.roughness = met->normal.y > 0.5 ? 0.18 : met->normal.z > 0.5 ? 0.42 : 0.9;
    hit.reflectance = met->normal.y > 0.5 ? 0.05 : 0.04;
    hit.albedo = met->albedo;
    hit.emitted = met->emitted;
    return hit;
  }
  const Box& bounds() const override { return bounds_; }

 private:
  House house_;
  Box bounds_ = house_.bounds();
};

Scene seenScene() {
  Scene scene = House().scene();
  Camera eye;
  eye.position = {-1.9, 1.6, 2.2};
  eye.target = {1.0, 0.2, 0.3};
  eye.verticalFovDegrees = 50.0;
  scene.cameras = {eye};
  eye.name = "other";
  eye.position = {2.1, 1.2, -0.6};
  eye.target = {-1.0, 0.4, 1.2};
  eye.parallelHeight = 2.1;
  scene.cameras.push_back(eye);
  return scene;
}

Probe askew() {
  Probe probe = House().scene().probes[0];
  probe.origin = {0.1, 1.4, 0.2};
  probe.box = {{-1.7, 0.3, -1.2}, {2.1, 2.2, 2.4}};
  probe.rotationDegrees = {0.0, 7.0, 0.0};
  return probe;
}

std::string facesText(const std::array<double, kFaces>& faces) {
  std::string text;
  for (const double face : faces) text += " " + keptNumber(face, 4);
  return text;
}

std::string errorsText(const LookupErrors& errors) {
  return keptNumber(errors.meanDegrees, 4) + " " + keptNumber(errors.p95Degrees, 4) + " " +
         keptNumber(errors.above5, 4);
}

std::string offsetText(const OffsetBox& box) {
  return facesText(box.offset) + " turned " + keptNumber(box.yaw, 4);
}

template <typename Item, typename Number>
void addDigest(Lines& lines, const std::string& name, const std::vector<Item>& items, const Number& number) {
  std::vector<double> values;
  for (const Item& item : items) values.push_back(number(item));
  lines.push_back("  " + name + ": " + digest(values));
}

template <typename Item>
void addVectors(Lines& lines, const std::string& name, const std::vector<Item>& items, dvec3 Item::*vector) {
  for (int axis = 0; axis < 3; ++axis) {
    addDigest(lines, name + " " + "xyz"[axis], items, [&](const Item& item) { return (item.*vector)[axis]; });
  }
}

void addFit(Lines& lines, const BoxFit& fit) {
  lines.push_back("  outcome " + std::to_string(static_cast<int>(fit.outcome)) + " " + keptBox(fit.probe.box) + " by " +
                  keptVector(fit.probe.rotationDegrees, 4) + " from " + keptVector(fit.probe.origin, 4) +
                  ", influence " + keptBox(fit.probe.influenceBox()));
  lines.push_back("  errors " + errorsText(fit.before) + " then " + errorsText(fit.after) + ", hidden " +
                  keptNumber(fit.hiddenBefore, 4) + " " + keptNumber(fit.hidden, 4) + ", open " +
                  keptNumber(fit.open, 4));
  for (const FaceFit& face : fit.faces) {
    lines.push_back("    face " + keptNumber(face.gainDegrees, 3) + " " + keptNumber(face.sensitivity, 3) +
                    (face.free ? " free" : ""));
  }
  for (const Phrase& remark : fit.remarks) lines.push_back("    " + remark.english());
}

void addRays(Lines& lines, const FitPlace& place, const Probe& probe) {
  const ReflectedRays reflected = reflectedRays(place, probe, 500, 0.3);
  lines.push_back("rays of " + probe.name + ", open " + keptNumber(reflected.open));
  addVectors(lines, "from", reflected.rays, &ReflectedRay::from);
  addVectors(lines, "along", reflected.rays, &ReflectedRay::along);
  addVectors(lines, "hit", reflected.rays, &ReflectedRay::hit);
  addVectors(lines, "normal", reflected.rays, &ReflectedRay::hitNormal);
  addVectors(lines, "eye", reflected.rays, &ReflectedRay::eye);
  addVectors(lines, "of", reflected.rays, &ReflectedRay::fromNormal);
  addDigest(lines, "weight", reflected.rays, [](const ReflectedRay& r) { return r.weight; });
  addDigest(lines, "roughness", reflected.rays, [](const ReflectedRay& r) { return r.roughness + (r.seen ? 1 : 0); });

  const glm::dmat3 worldFromBox = rotationMatrix(probe.rotationDegrees);
  const LookupRays lookups = lookupRays(place, reflected, probe.origin, worldFromBox);
  lines.push_back("lookups, hidden " + keptNumber(lookups.hidden));
  addVectors(lines, "from", lookups.rays, &LookupRay::from);
  addVectors(lines, "along", lookups.rays, &LookupRay::along);
  addVectors(lines, "target", lookups.rays, &LookupRay::target);
  addDigest(lines, "weight", lookups.rays, [](const LookupRay& r) { return r.weight; });
  addDigest(lines, "of", lookups.rays, [](const LookupRay& r) { return static_cast<double>(r.reflected); });
  const OffsetBox box = offsetBox(probe);
  lines.push_back("box" + offsetText(box) + ", errors " + errorsText(lookupErrors(lookups, box)) + ", mean " +
                  keptNumber(meanError(lookups, box)) + ", sensitive" + facesText(faceSensitivities(lookups, box)));
  addDigest(lines, "exits", lookups.rays, [&](const LookupRay& r) { return boxExit(r, box.offset).distance; });
  addDigest(lines, "faces", lookups.rays, [&](const LookupRay& r) { return double(boxExit(r, box.offset).face); });
  const LookupRays some = someOf(turnedBy(lookups, 0.4), 60);
  lines.push_back("some " + std::to_string(some.rays.size()) + ", hidden " + keptNumber(some.hidden));
  addVectors(lines, "turned", some.rays, &LookupRay::along);

  const std::vector<MetPoint> points = metPoints(place, reflected, probe.origin, worldFromBox);
  lines.push_back("met " + std::to_string(points.size()));
  addVectors(lines, "at", points, &MetPoint::position);
  addDigest(lines, "weight", points, [](const MetPoint& p) { return p.weight; });
  const UprightYaw yaw = uprightYaw(points);
  const FacePlanes planes = facePlanes(turnedBy(points, yaw.yaw));
  lines.push_back("walls at " + keptNumber(yaw.yaw) + " by " + keptNumber(yaw.strength) + ", likeliest" +
                  facesText(planes.likeliest));
  for (const auto& offsets : planes.offsets) {
    std::string text = "  planes";
    for (const double offset : offsets) text += " " + keptNumber(offset, 4);
    lines.push_back(text);
  }
  const std::vector<RatedBox> best = bestCombinations(turnedBy(lookups, yaw.yaw), planes.offsets, 4, yaw.yaw);
  for (const RatedBox& rated : best) {
    lines.push_back("  rated" + offsetText(rated.box) + ": " + keptNumber(rated.meanDegrees, 4) + ", extent " +
                    keptNumber(extentOf(rated.box), 4));
  }
  PolishSettings settings;
  settings.faces[1] = false;
  settings.nearest = 0.3;
  settings.lastStep = 0.003;
  const RatedBox polish = polished(lookups, best.front().box, settings);
  lines.push_back("  polished" + offsetText(polish.box) + ": " + keptNumber(polish.meanDegrees, 4) + ", with margin" +
                  offsetText(withMargin(polish.box, lookups, settings.faces)));
}

TEST(FitValues, AreKept) {
  const HouseRays rays;
  const Scene scene = seenScene();
  const FitPlace place{rays, rays, scene.cameras};
  Lines lines;
  for (Probe probe : {askew(), scene.probes[1]}) {
    lines.push_back("== " + probe.name);
    lines.push_back("walled " + keptNumber(walledAround(rays, probe.origin)) +
                    (insideOfSolid(rays, probe.origin) ? " inside" : " outside") + ", errors " +
                    errorsText(boxErrors(place, probe, 700, 0.2)));
    addRays(lines, place, probe);
    BoxFitSettings settings;
    settings.rays = 700;
    addFit(lines, *fitBox(place, probe, settings));
    settings.faces[3] = settings.yaw = false;
    addFit(lines, *fitBox(place, probe, settings));
    const BoxGauge gauge = *BoxGauger(place, probe, 700).measure(probe);
    lines.push_back("gauge " + errorsText(gauge.errors) + " hidden " + keptNumber(gauge.hidden, 4) + " worst " +
                    (gauge.worst ? std::to_string(*gauge.worst) : "none"));
    for (const FaceGauge& face : gauge.faces) {
      lines.push_back("  face " + keptNumber(face.meanDegrees, 4) + " " + keptNumber(face.share, 4) + " " +
                      keptNumber(face.offset, 4) + " " + keptNumber(face.gainDegrees, 4));
    }
    if (gauge.spot) {
      lines.push_back("  spot " + keptVector(gauge.spot->positionWorld, 4) + " from " +
                      keptVector(gauge.spot->eyeWorld, 4) + " " + keptNumber(gauge.spot->degrees, 4));
    }
    lines.push_back("counted " + keptNumber(countedGain(0.3)) + " " + keptNumber(countedGain(9.0)));
    for (int face = 0; face < kFaces; ++face) {
      const Probe moved = withFaceAt(probe, face, 1.3 + 0.1 * face);
      lines.push_back("  moved " + keptBox(moved.box) + ", influence " + keptBox(moved.influenceBox()));
    }
    lines.push_back("turned influence " + keptBox(turnedInfluence({{-3.0, -1.0, -2.0}, {1.0, 2.0, 4.0}}, probe)));
    const ReflectedRays reflected = reflectedRays(place, probe, 400, 0.6);
    for (const dvec3& off : {dvec3(0.0), dvec3(0.7, -0.9, 0.4), dvec3(-0.6, 0.5, -0.3)}) {
      Probe at = probe;
      at.origin += off;
      lines.push_back("cost " + keptNumber(originCost(place, reflected, at), 4));
    }
    addFit(lines, *proposeOrigin(place, probe, settings));
  }
  lines.emplace_back("== captured distances");
  const glm::dmat3 turn = rotationMatrix({10.0, 20.0, 30.0});
  const dvec3 origin(0.3, 1.3, 1.7);
  const CubeMap cube = distanceCube(rays, origin, turn, 32);
  const DistanceRays captured(cube, origin, turn);
  std::vector<double> distances, normals;
  for (const dvec3& direction : fibonacciDirections(60, 0.2)) {
    const auto hit = captured.first(origin + dvec3(0.4, -0.5, 0.3), direction);
    distances.push_back(hit ? hit->distance : 0.0);
    normals.push_back(hit ? hit->normalWorld.x + 2.0 * hit->normalWorld.y + 3.0 * hit->normalWorld.z : 0.0);
  }
  lines.push_back("distances " + digest(distances));
  lines.push_back("normals " + digest(normals));
  lines.push_back("bounds " + keptBox(captured.bounds()) + ", a direction " + keptVector(sphereDirection(0.3, 0.8)));
  test::expectKeptValues("unit/values/fit_values.txt", lines);
}

void addProbe(Lines& lines, const Probe& probe) {
  lines.push_back("  probe " + probe.name + " from " + keptVector(probe.origin, 3) + ", " + keptBox(probe.box) +
                  " by " + keptVector(probe.rotationDegrees, 3) + ", influence " + keptBox(probe.influenceBox()) +
                  ", blend " + keptVector(probe.blendDistance.min, 3) + " and " +
                  keptVector(probe.blendDistance.max, 3) + ", importance " + keptNumber(probe.importance) +
                  ", bounces " + std::to_string(probe.bounces));
}

void addCamera(Lines& lines, const Camera& camera) {
  lines.push_back("  camera " + camera.name + " at " + keptVector(camera.position, 4) + " to " +
                  keptVector(camera.target, 4) + " " + keptNumber(camera.verticalFovDegrees, 4));
}

TEST(PlaceValues, OfRoomsAreKept) {
  const HouseRays rays;
  Lines lines;
  const WalledRegion region = *walledRegion(rays);
  lines.push_back("region turned " + keptNumber(region.yaw) + ", " + keptBox(region.bounds) + ", height " +
                  keptNumber(region.height));
  const Rooms rooms = *findRooms(rays);
  const FreeSpace& space = rooms.space;
  lines.push_back("space of " + keptNumber(space.cell) + " from " + keptVector(space.first) + ", " +
                  std::to_string(space.count.x) + " " + std::to_string(space.count.y) + " " +
                  std::to_string(space.count.z) + ", behind " + keptNumber(space.backVolume) + ", hollows " +
                  std::to_string(rooms.hollows));
  lines.push_back("open " + digest({space.open.begin(), space.open.end()}));
  lines.push_back("depth " + digest({space.depth.begin(), space.depth.end()}));
  std::vector<PlacedProbe> probes;
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    const Room& room = rooms.rooms[i];
    lines.push_back("room of " + std::to_string(room.cells.size()) + " cells, " + std::to_string(room.parts.size()) +
                    " parts, " + keptBox(room.extent) + ", volume " + keptNumber(room.volume) + ", roofed " +
                    keptNumber(room.roofed) + (room.outdoors ? " outdoors" : ""));
    for (const Camera& eye : eyesIn(rays, rooms, room)) addCamera(lines, eye);
    PlacedProbe placed;
    placed.room = i;
    placed.probe.name = "room " + std::to_string(i);
    placed.probe.origin = space.worldPosition(room.cells[room.cells.size() / 2]);
    setBoxAbout(placed.probe, space, room.cells, {0.0, 3.0 * static_cast<double>(i), 0.0});
    keepApart(rooms, i, placed.probe);
    probes.push_back(placed);
  }
  for (const Doorway& door : rooms.doorways) {
    lines.push_back("door " + std::to_string(door.a) + " to " + std::to_string(door.b) + " " + keptNumber(door.area) +
                    " " + keptVector(door.normal));
  }
  setInfluences(rays, rooms, probes);
  for (const PlacedProbe& placed : probes) addProbe(lines, placed.probe);
  const std::vector<SeenPlace> seen = seenFromRooms(rays, rooms);
  addVectors(lines, "seen", seen, &SeenPlace::positionWorld);
  addVectors(lines, "normal", seen, &SeenPlace::normalWorld);
  std::vector<Probe> own;
  for (const PlacedProbe& placed : probes) own.push_back(placed.probe);
  lines.push_back("bare " + keptNumber(bareShare(seen, own)) + ", of one " + keptNumber(bareShare(seen, {own.back()})));
  std::vector<PlacedProbe> grown = {probes.front()};
  std::vector<std::pair<std::size_t, std::size_t>> above;
  growOverSeen(seen, {own.back()}, 2.6, grown, above);
  addProbe(lines, grown.front().probe);
  grown = probes;
  growOverSeen(seen, {}, 2.6, grown, above);
  for (const PlacedProbe& placed : grown) addProbe(lines, placed.probe);
  for (const auto& [a, b] : above) lines.push_back("  above " + std::to_string(a) + " " + std::to_string(b));
  for (const auto& [a, b] : overlaps(grown))
    lines.push_back("  overlap " + std::to_string(a) + " " + std::to_string(b));
  const auto around = surroundingsProbe(rays, rooms, seen, {own.front()});
  lines.push_back(around ? "surroundings" : "no surroundings");
  if (around) addProbe(lines, around->probe);
  Probe part = own.front();
  const std::vector<std::size_t>& cells = rooms.rooms[0].cells;
  setPartInfluence(rays, space, {cells.begin(), cells.begin() + static_cast<long>(cells.size() / 3)}, own.front(),
                   part);
  addProbe(lines, part);
  for (const dvec3& place : {dvec3(0.0, 1.0, 0.0), dvec3(3.7, 1.0, -2.9), dvec3(-5.0, 4.0, -6.0)}) {
    Probe reaching = own.back();
    lines.push_back("  distance " + keptNumber(influenceDistance(reaching, place)));
    reachOver(reaching, place, 0.23);
    addProbe(lines, reaching);
    lines.push_back("  shared " + keptNumber(sharedVolume(own.front(), reaching)));
  }
  test::expectKeptValues("unit/values/room_values.txt", lines);
}

TEST(PlaceValues, OfModelsAreKept) {
  Lines lines;
  const House house;
  Scene scene = seenScene();
  auto model = std::make_shared<Model>(*house.model());
  for (Material& material : model->materials) {
    material.metallic = 0.0f;
    material.roughness = material.name.rfind("floor", 0) == 0 ? 0.2f : 0.7f;
  }
  const TriangleRays::Models models = {model};
  const TriangleRays rays(scene, models);
  lines.push_back("bounds " + keptBox(rays.bounds()) + ", core " + keptBox(rays.core()));
  std::vector<double> distances, sides, looks, albedo, emitted;
  for (const dvec3& direction : fibonacciDirections(300, 0.4)) {
    const auto hit = rays.first({0.31, 1.27, 0.83}, direction);
    distances.push_back(hit ? hit->distance : 0.0);
    sides.push_back(hit ? hit->normalWorld.x + 2.0 * hit->normalWorld.y + 3.0 * hit->normalWorld.z + hit->back : 9.0);
    looks.push_back(hit ? hit->roughness + hit->reflectance : 9.0);
    albedo.push_back(hit ? hit->albedo.x + 2.0 * hit->albedo.y + 3.0 * hit->albedo.z : 9.0);
    emitted.push_back(hit ? hit->emitted.x + 2.0 * hit->emitted.y + 3.0 * hit->emitted.z : 9.0);
  }
  for (const auto& [name, values] : {std::pair("distances", distances),
                                     {"sides", sides},
                                     {"looks", looks},
                                     {"albedo", albedo},
                                     {"emitted", emitted}}) {
    lines.push_back(std::string(name) + " " + digest(values));
  }
  const ModelSurvey survey = surveyModel(rays);
  lines.push_back(std::string("survey ") + modelKindId(survey.kind) + " " + keptNumber(survey.solid, 3) + " " +
                  keptNumber(survey.enclosed, 3) + " " + keptNumber(survey.walled, 3) + " " +
                  keptNumber(survey.floored, 3) + " sky " + keptNumber(survey.sky, 3) + " outside " +
                  keptNumber(survey.backOutside, 3) + ", " + keptNumber(survey.largest, 4) + ": " +
                  survey.reason.english());
  addVectors(lines, "points", survey.points, &SurveyedPoint::positionWorld);
  addDigest(lines, "front", survey.points, [](const SurveyedPoint& p) { return p.front + 2.0 * p.back + 3.0 * p.sky; });
  addDigest(lines, "below", survey.points, [](const SurveyedPoint& p) { return p.frontBelow + 2.0 * p.frontAround; });
  addDigest(lines, "clear", survey.points, [](const SurveyedPoint& p) { return p.clearance; });
  const std::vector<StandingPoint> stands = standingPoints(rays, survey);
  addVectors(lines, "stands", stands, &StandingPoint::eyeWorld);
  for (std::size_t i = 0; i < stands.size() && i < 3; ++i) {
    lines.push_back("  stand " + keptVector(stands[i].eyeWorld) + " floor " + keptNumber(stands[i].floor) + " height " +
                    keptNumber(stands[i].height) + " clear " + keptNumber(stands[i].clearance));
  }
  for (const double aspect : {0.55, 0.83, 1.0, 1.31, 1.6, 1.78, 2.1, 2.7}) {
    lines.push_back("view of aspect " + keptNumber(aspect));
    addCamera(lines, roomCamera(rays, stands, aspect));
  }
  addProbe(lines, roomProbe(rays, stands.front()));
  for (const auto light : {std::optional<FitLight>(), std::optional(FitLight::Ceiling), std::optional(FitLight::Studio),
                           std::optional(FitLight::Openings), std::optional(FitLight::Daylight)}) {
    FitWishes wishes;
    wishes.light = light;
    wishes.box.rays = 400;
    if (light == FitLight::Studio) {
      wishes.kind = ModelKind::Object;
      wishes.aspect = 0.7;
    }
    Scene fitted = scene;
    const ModelFit fit = fitModel(fitted, models, wishes);
    lines.push_back("== " + fit.decided.english() + (fit.within ? ", within" : "") +
                    (fit.lightKnown ? ", its light known" : ""));
    if (fit.box) addFit(lines, *fit.box);
    for (const Camera& camera : fitted.cameras) addCamera(lines, camera);
    for (const Light& l : fitted.lights) {
      lines.push_back("  light " + std::to_string(static_cast<int>(l.type)) + " " + keptVector(l.position, 4) +
                      " along " + keptVector(l.direction, 4) + " " + keptVector(l.color) + " " +
                      keptNumber(static_cast<double>(l.intensity), 4) + " cone " + keptNumber(l.innerConeDegrees, 4) +
                      " " + keptNumber(l.outerConeDegrees, 4) + " range " + keptNumber(l.range, 4) + " radius " +
                      keptNumber(l.radius, 4) + " shadows " + std::to_string(static_cast<int>(l.shadows)));
    }
    for (const Probe& probe : fitted.probes) addProbe(lines, probe);
  }
  PlaceSettings settings;
  settings.rays = 300;
  settings.most = 4;
  lines.emplace_back("== placed");
  const Placement placement = *placeProbes(scene, models, settings);
  for (const PlacedRoom& room : placement.rooms) {
    lines.push_back("  " + room.name + " " + keptBox(room.extent) + " turned " + keptNumber(room.yawDegrees, 3) +
                    " about " + keptVector(room.middleWorld, 4) + ", volume " + keptNumber(room.volume, 4) + ", " +
                    std::to_string(room.parts) + " parts" + (room.outdoors ? " outdoors" : "") +
                    (room.reflects ? " reflects" : "") + ", error " + keptNumber(room.before.meanDegrees, 3) +
                    " then " + keptNumber(room.after.meanDegrees, 3) + " " + keptNumber(room.after.p95Degrees, 3) +
                    " hidden " + keptNumber(room.after.hidden, 3) + " unlit " + keptNumber(room.after.unlit, 3));
    for (const dvec3& origin : room.origins) lines.push_back("    free " + keptVector(origin, 4));
    for (const Camera& eye : room.eyes) addCamera(lines, eye);
  }
  for (const PlacedProbe& placed : placement.probes) addProbe(lines, placed.probe);
  for (const Phrase& remark : placement.remarks) lines.push_back("  " + remark.english());
  lines.push_back("  all " + keptNumber(placement.before.meanDegrees, 3) + " then " +
                  keptNumber(placement.after.meanDegrees, 3) + ", bare " + keptNumber(placement.bareBefore, 3) + " " +
                  keptNumber(placement.bareAfter, 3) + ", " + std::to_string(placement.cells) + " cells of " +
                  keptNumber(placement.cell));
  test::expectKeptValues("unit/values/place_values.txt", lines);
}

TEST(FitValues, OfExposureUnitsAndNamesAreKept) {
  Lines lines;
  ImageRgbaF picture;
  picture.width = 16;
  picture.height = 9;
  for (int i = 0; i < 16 * 9; ++i) {
    const float light = std::exp(0.045f * static_cast<float>(i * 31 % 144) - 3.0f);
    picture.pixels.insert(picture.pixels.end(), {light, 0.8f * light, 0.5f * light, i % 5 == 0 ? 0.0f : 1.0f});
  }
  for (const Tone tone : {Tone::None, Tone::Neutral, Tone::Agx, Tone::Aces, Tone::AsVtk}) {
    lines.push_back("exposure " + keptNumber(keyedExposure(picture, false, tone)) + ", with the sky " +
                    keptNumber(keyedExposure(picture, true, tone)));
  }
  for (float& value : picture.pixels) value *= value;
  lines.push_back("exposure of contrast " + keptNumber(keyedExposure(picture, false)));
  for (const char* file : {"a.glb", "a.obj", "a.stl", "a.ply", "a.vtp"}) {
    std::string text = std::string("unit of ") + file + ":";
    for (const ModelKind kind : {ModelKind::Object, ModelKind::Interior, ModelKind::Open}) {
      for (double size = 0.003; size < 1e6; size *= 3.1) {
        text += " " + std::to_string(static_cast<int>(likelyUnit(file, kind, size)));
      }
    }
    lines.push_back(text);
  }
  for (const dvec3& size : {dvec3(940.0, 300.0, 2.0), dvec3(0.031, 0.2, 0.1), dvec3(3.0, 4000000.0, 1.0)}) {
    lines.push_back("extent " + extentText({dvec3(0.0), size}).english());
  }
  for (const char* node : {"Kitchen_Floor.001", "LivingRoomSofa", "bed room lamp", "WC_door", "Cube.003", "hall-way",
                           "officeDesk2", "BATH", "staircase", "Plane"}) {
    lines.push_back(std::string("named ") + node + ": '" + roomNamedBy(node) + "'");
  }
  std::string numbered;
  for (const std::string& name :
       numberedRooms({"kitchen", "", "kitchen", "", "hall", "kitchen", ""}, {0, 2, 1, 1, 0, 0, 3})) {
    numbered += " '" + name + "'";
  }
  lines.push_back("numbered" + numbered);
  lines.push_back(std::string("lights ") + fitLightId(FitLight::Openings) + " " +
                  std::to_string(allFitLights().size()) + ", sun " + keptVector(sunLight().at(0).direction) + " " +
                  keptNumber(static_cast<double>(sunLight().at(0).intensity)));
  test::expectKeptValues("unit/values/guess_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
