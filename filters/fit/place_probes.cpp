// See place_probes.h.
#include "filters/fit/place_probes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "filters/core/base/number_text.h"
#include "filters/fit/place_cover.h"
#include "filters/fit/place_eyes.h"
#include "filters/fit/place_influence.h"
#include "filters/fit/room_fit.h"
#include "filters/fit/room_names.h"

namespace boxprobe {

namespace {

constexpr int kScoreRays = 2048;
constexpr std::size_t kMostParts = 8;
constexpr std::size_t kMostRanks = 8;  // of importance; a limit, should probes be above each other in a cycle
constexpr double kLeastPart = 0.08;    // of its room's volume
constexpr double kRoofed = 0.3, kLeastGloss = 0.02;
constexpr double kMostBare = 0.003;  // of what is seen; more gets a probe of its own
constexpr double kLong = 1.5;        // rooms longer than this ratio are also tried in halves

using Clock = std::chrono::steady_clock;

double secondsSince(const Clock::time_point& begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

std::string decimals(double value, int count = 2) {
  return decimalText(value, count);
}

/// Do rays in every direction meet mostly back faces? With inverted faces this is a room.
bool amongBacks(const SurfaceRays& rays, const glm::dvec3& position) {
  constexpr int kLooks = 96;
  int backs = 0;
  for (const glm::dvec3& direction : fibonacciDirections(kLooks)) {
    const std::optional<SurfaceHit> hit = rays.first(position, direction);
    backs += hit && hit->back ? 1 : 0;
  }
  return backs > 0.8 * kLooks;
}

/// Rooms are fitted for people standing in them: a camera sees only the room that it is in, from one place.
Scene withoutCameras(Scene scene) {
  scene.cameras.clear();
  return scene;
}

/// The share of visible reflections that is from smooth surfaces.
double glossOf(const ReflectedRays& rays) {
  double smooth = 0.0, all = 0.0;
  for (const ReflectedRay& ray : rays.rays) {
    if (!ray.seen) continue;
    all += ray.weight;
    smooth += ray.roughness < 0.6 ? ray.weight : 0.0;
  }
  return all > 0.0 ? smooth / all : 0.0;
}

/// Of the rooms that reflect, weighted by volume.
LitErrors overRooms(const std::vector<PlacedRoom>& rooms, LitErrors PlacedRoom::*errors) {
  double volume = 0.0;
  for (const PlacedRoom& room : rooms) volume += room.reflects ? room.volume : 0.0;
  LitErrors sum;
  for (const PlacedRoom& room : rooms) {
    if (!room.reflects) continue;
    const LitErrors& each = room.*errors;
    const double weight = room.volume / volume;
    sum.meanDegrees += weight * each.meanDegrees;
    sum.p95Degrees += weight * each.p95Degrees;
    sum.hidden += weight * each.hidden;
    sum.unlit += weight * each.unlit;
  }
  return sum;
}

/// What a person has chosen for the scene's own probes holds for others: how they are captured, filtered and looked up.
void inheritSettings(const std::vector<Probe>& own, Probe& probe) {
  const auto away = [&](const Probe& each) { return glm::length(each.origin - probe.origin); };
  const auto nearest =
      std::min_element(own.begin(), own.end(), [&](const Probe& a, const Probe& b) { return away(a) < away(b); });
  if (nearest == own.end()) return;
  probe.technique = nearest->technique;
  probe.parameters = nearest->parameters;
  probe.clear = nearest->clear;
  probe.faceSize = nearest->faceSize;
  probe.bounces = nearest->bounces;
  probe.filter = nearest->filter;
  probe.samplesPerPixel = nearest->samplesPerPixel;
  probe.filterSamples = nearest->filterSamples;
  probe.lattice = nearest->lattice;
}

class Placer {
 public:
  Placer(const Scene& scene, const TriangleRays::Models& models, const PlaceSettings& settings,
         const FitProgress& progress)
      : scene_(scene),
        models_(models),
        settings_(settings),
        progress_(progress),
        rating_(std::make_shared<PlaceRating>(PlaceRating{ProbeFitter(withoutCameras(scene), models), {}, {}})),
        fitter_(rating_->fitter) {}

  std::optional<Placement> place() {
    const Clock::time_point begun = Clock::now();
    if (!findAll(begun)) return std::nullopt;
    if (!placeInRooms() || !placeInParts() || !judge()) return std::nullopt;
    finish();
    placement_.seconds = secondsSince(begun);
    return std::move(placement_);
  }

  bool fitShare() {
    if (!findAll(Clock::now())) return false;
    std::size_t fits = 0;
    for (std::size_t i = 0; i < rooms_.rooms.size(); ++i) {
      const double from = 0.25 + 0.75 * static_cast<double>(i) / roomCount();
      if (holds(i)) continue;
      const std::vector<std::size_t>& cells = rooms_.rooms[i].cells;
      const Probe about = roomFits_->start(cells);
      if (!reflects(rooms_.rooms[i], reflectedRays(fitter_.placeOf(about), about, kScoreRays, kScoreTurn))) continue;
      if (placement_.kept.size() + fits >= settings_.most) break;
      if (settings_.shared->mine(fits++) && !fitOf(roomFit(i), cells, part(from, from + 0.75 / roomCount()))) {
        return false;
      }
      if (!part(from, from)(0.0)) return false;
    }
    return true;
  }

 private:
  bool findAll(const Clock::time_point& begun) {
    RoomSettings wanted{settings_.inverted};
    const auto inBacks = [&](const glm::dvec3& at) { return amongBacks(captured(), at); };
    for (const Camera& camera : scene_.cameras) wanted.inverted = wanted.inverted || inBacks(camera.position);
    for (const Probe& probe : scene_.probes) wanted.inverted = wanted.inverted || inBacks(probe.origin);
    std::optional<Rooms> rooms = findRooms(captured(), wanted, part(0.0, 0.25));
    if (!rooms) return false;
    rooms_ = *std::move(rooms);
    roomFits_.emplace(fitter_, rooms_, settings_.rays);
    roomOf_ = roomOfCells(rooms_);
    describeRooms();
    placement_.roomSeconds = secondsSince(begun);
    if (settings_.keep && !rooms_.rooms.empty()) keepProbes();
    return true;
  }

  static std::string roomFit(std::size_t room) { return "room-" + std::to_string(room + 1); }

  /// One that another process made is the same.
  std::optional<BoxFit> fitOf(const std::string& name, const std::vector<std::size_t>& cells,
                              const FitProgress& progress) const {
    if (settings_.shared == nullptr) return roomFits_->fit(cells, progress);
    std::optional<BoxFit> fit = settings_.shared->find(name, roomFits_->start(cells));
    if (fit) return fit;
    fit = roomFits_->fit(cells, progress);
    if (fit) settings_.shared->keep(name, *fit);
    return fit;
  }

  static bool reflects(const Room& room, const ReflectedRays& rays) {
    return room.roofed >= kRoofed || glossOf(rays) >= kLeastGloss;
  }

  FitProgress part(double from, double to) const {
    return [this, from, to](double done) { return !progress_ || progress_(from + (to - from) * done); };
  }

  const SurfaceRays& captured() { return fitter_.placeOf(Probe{}).captured; }

  void describeRooms() {
    const FreeSpace& space = rooms_.space;
    placement_.cell = space.cell;
    placement_.cells = space.depth.size();
    placement_.rooms.resize(rooms_.rooms.size());
    for (std::size_t i = 0; i < rooms_.rooms.size(); ++i) {
      const Room& room = rooms_.rooms[i];
      PlacedRoom& placed = placement_.rooms[i];
      placed.extent = room.extent;
      placed.yawDegrees = glm::degrees(rooms_.region.yaw);
      placed.middleWorld = space.worldFromGrid * room.extent.center();
      placed.volume = room.volume;
      placed.outdoors = room.outdoors;
      placed.parts = room.parts.size();
    }
    for (const Doorway& doorway : rooms_.doorways) {
      placement_.rooms[doorway.a].doorways.push_back(doorway);
      placement_.rooms[doorway.b].doorways.push_back({doorway.b, doorway.a, doorway.area, -doorway.normal});
    }
    std::vector<Phrase>& remarks = placement_.remarks;
    if (rooms_.rooms.empty()) {
      const double least = std::pow(0.45 * rooms_.region.height, 3.0);
      const bool backs = space.backVolume > std::max(least, 0.0) && !space.backsAreFronts;
      remarks.push_back(
          backs
              ? Phrase::tr("no room was found: back sides of surfaces close in the space within; if it is a room, its "
                           "faces are inverted: turn them over, or use --as interior")
              : Phrase::tr("open: no room was found; nothing is closed in by a floor and walls"));
      placement_.kept = scene_.probes;
      if (!scene_.probes.empty()) remarks.push_back(Phrase::tr("the scene's probes stay"));
    } else if (space.backsAreFronts) {
      remarks.push_back(Phrase::tr("the walls show their back sides to the rooms: the model's faces are inverted"));
    }
    if (rooms_.hollows > 0) {
      remarks.push_back(Phrase::tr("%1 closed spaces are too small for a room and have no probe")
                            .arg(std::to_string(rooms_.hollows)));
    }
    if (space.cell > 0.1001 * rooms_.region.height) {
      remarks.push_back(Phrase::tr("the model is very large for the height of its rooms: doors may be missed"));
    }
  }

  std::optional<std::size_t> roomAt(const glm::dvec3& world) const {
    const std::optional<std::size_t> cell = cellAt(rooms_.space, world);
    if (!cell || roomOf_[*cell] == rooms_.rooms.size()) return std::nullopt;
    return roomOf_[*cell];
  }

  void keepProbes() {
    placement_.kept = scene_.probes;
    for (const Probe& probe : scene_.probes) {
      const std::optional<std::size_t> room = roomAt(probe.origin);
      if (room) {
        held_.push_back(*room);
        placement_.rooms[*room].decisions.push_back(Phrase::tr("it has the probe %1, which is kept").arg(probe.name));
      } else {
        placement_.remarks.push_back(
            Phrase::tr("%1: its origin is in no room, inside of a wall or in the open; it is kept").arg(probe.name));
      }
    }
  }

  double roomCount() const { return static_cast<double>(rooms_.rooms.size()); }
  bool full() const { return placement_.kept.size() + placement_.probes.size() >= settings_.most; }
  bool holds(std::size_t room) const { return std::find(held_.begin(), held_.end(), room) != held_.end(); }

  bool placeInRooms() {
    for (std::size_t i = 0; i < rooms_.rooms.size(); ++i) {
      const double from = 0.25 + 0.45 * static_cast<double>(i) / roomCount();
      PlacedRoom& placed = placement_.rooms[i];
      Probe about = roomFits_->start(rooms_.rooms[i].cells);
      rating_->rays.push_back(reflectedRays(fitter_.placeOf(about), about, kScoreRays, kScoreTurn));
      if (!part(from, from)(0.0)) return false;
      if (holds(i)) continue;
      placed.reflects = reflects(rooms_.rooms[i], rating_->rays.back());
      if (!placed.reflects) {
        placed.decisions.push_back(
            Phrase::tr("left out: it has no ceiling, and no surface in it is smoother than roughness 0.6"));
        continue;
      }
      if (full()) {
        placed.decisions.push_back(
            Phrase::tr("left out: no more than %1 probes were asked for").arg(std::to_string(settings_.most)));
        continue;
      }
      const std::optional<BoxFit> fit = fitOf(roomFit(i), rooms_.rooms[i].cells, part(from, from + 0.4 / roomCount()));
      if (!fit) return false;
      placement_.probes.push_back({fit->probe, i, false, 0.0, *fit});
    }
    setInfluences(captured(), rooms_, placement_.probes);
    for (PlacedProbe& placed : placement_.probes) {
      const LitErrors errors = litErrors(fitter_, rating_->rays[placed.room], {placed.probe});
      placed.gainDegrees = kHiddenDegrees - errors.meanDegrees;
      placement_.rooms[placed.room].decisions.push_back(Phrase::tr("its first probe leaves %1 of %2 degrees")
                                                            .arg(decimals(errors.meanDegrees))
                                                            .arg(decimals(kHiddenDegrees, 0)));
    }
    return true;
  }

  /// Parts of a room that could get more probes: those between narrow places, and the halves of a long room.
  std::vector<std::vector<std::size_t>> partsOf(const Room& room) const {
    std::vector<std::vector<std::size_t>> parts;
    const double least = kLeastPart * static_cast<double>(room.cells.size());
    for (const std::vector<std::size_t>& part : room.parts) {
      if (room.parts.size() > 1 && static_cast<double>(part.size()) >= least) parts.push_back(part);
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    if (parts.size() > kMostParts) parts.resize(kMostParts);
    const glm::dvec3 size = room.extent.size();
    const int axis = size.x > size.z ? 0 : 2;
    if (size[axis] >= kLong * size[2 - axis]) {
      std::vector<std::size_t> halves[2];
      for (const std::size_t cell : room.cells) {
        halves[rooms_.space.gridPosition(cell)[axis] < room.extent.center()[axis] ? 0 : 1].push_back(cell);
      }
      for (std::vector<std::size_t>& half : halves) {
        if (static_cast<double>(half.size()) >= least) parts.push_back(std::move(half));
      }
    }
    return parts;
  }

  bool placeInParts() {
    for (std::size_t i = 0; i < rooms_.rooms.size(); ++i) {
      const double from = 0.7 + 0.25 * static_cast<double>(i) / roomCount();
      if (!part(from, from)(0.0)) return false;
      const auto first = std::find_if(placement_.probes.begin(), placement_.probes.end(),
                                      [i](const PlacedProbe& each) { return each.room == i; });
      if (first == placement_.probes.end()) continue;
      if (!placeInPartsOf(i, static_cast<std::size_t>(first - placement_.probes.begin()), from)) return false;
    }
    return true;
  }

  bool placeInPartsOf(std::size_t room, std::size_t first, double from) {
    std::vector<Phrase>& decisions = placement_.rooms[room].decisions;
    std::vector<Probe> chosen = {placement_.probes[first].probe};
    double error = litErrors(fitter_, rating_->rays[room], chosen).meanDegrees;
    const auto needed = [&] { return settings_.leastGain * (kHiddenDegrees - error); };
    if (error <= needed()) return true;  // even a perfect probe would not gain enough
    std::vector<PlacedProbe> candidates;
    const std::vector<std::vector<std::size_t>> parts = partsOf(rooms_.rooms[room]);
    for (const std::vector<std::size_t>& cells : parts) {
      const std::string name = roomFit(room) + "-part-" + std::to_string(candidates.size() + 1);
      const std::optional<BoxFit> fit = fitOf(name, cells, part(from, from));
      if (!fit) return false;
      PlacedProbe candidate{fit->probe, room, true, 0.0, *fit};
      keepApart(rooms_, room, candidate.probe);
      setPartInfluence(captured(), rooms_.space, cells, placement_.probes[first].probe, candidate.probe);
      candidates.push_back(std::move(candidate));
    }
    while (!candidates.empty()) {
      std::size_t best = 0;
      double least = 1e300;
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        std::vector<Probe> with = chosen;
        with.push_back(candidates[i].probe);
        const double cost = litErrors(fitter_, rating_->rays[room], with).meanDegrees;
        if (cost < least) best = i, least = cost;
      }
      if (error - least < needed()) {
        decisions.push_back(Phrase::tr("of %1 more places the best gains %2 degrees; %3 are needed")
                                .arg(std::to_string(candidates.size()))
                                .arg(decimals(error - least))
                                .arg(decimals(needed())));
        break;
      }
      if (full()) {
        decisions.push_back(Phrase::tr("one more would gain %1 degrees; no more than %2 probes were asked for")
                                .arg(decimals(error - least))
                                .arg(std::to_string(settings_.most)));
        break;
      }
      decisions.push_back(Phrase::tr("one more gains %1 degrees").arg(decimals(error - least)));
      candidates[best].gainDegrees = error - least;
      error = least;
      chosen.push_back(candidates[best].probe);
      placement_.probes.push_back(std::move(candidates[best]));
      candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
    }
    if (chosen.size() < 3) return true;
    chosen.erase(chosen.begin());
    const double without = litErrors(fitter_, rating_->rays[room], chosen).meanDegrees;
    if (without - error >= needed()) return true;
    decisions.push_back(Phrase::tr("the others cover its first probe, which gains only %1 degrees: left out")
                            .arg(decimals(without - error)));
    placement_.probes.erase(placement_.probes.begin() + static_cast<std::ptrdiff_t>(first));
    return true;
  }

  void coverSeen() {
    std::vector<PlacedProbe>& probes = placement_.probes;
    std::vector<SeenPlace>& seen = rating_->seen;
    seen = seenFromRooms(captured(), rooms_);
    const auto unused = [&](const SeenPlace& place) { return !placement_.rooms[place.room].reflects; };
    seen.erase(std::remove_if(seen.begin(), seen.end(), unused), seen.end());
    placement_.bareBefore = bareShare(seen, scene_.probes);
    growOverSeen(seen, placement_.kept, rooms_.region.height, probes, above_);
    const double bare = bareShare(seen, placement_.all());
    if (bare <= kMostBare || probes.empty() || full()) return;
    std::optional<PlacedProbe> outside = surroundingsProbe(captured(), rooms_, seen, placement_.all());
    if (!outside) return;
    probes.push_back(*std::move(outside));
    const double left = bareShare(seen, placement_.all());
    probes.back().reason = Phrase::tr("for what is seen outside of the rooms: %1 % of all surfaces")
                               .arg(decimals(100.0 * (bare - left), 1));
  }

  /// Where influence boxes overlap, the more important probe is the one with which both rooms together have the smaller
  /// error.
  void setImportance() {
    std::vector<PlacedProbe>& probes = placement_.probes;
    std::vector<std::pair<std::size_t, std::size_t>> above = above_;  // the second above the first
    const auto known = [&](std::size_t a, std::size_t b) {
      return std::find(above_.begin(), above_.end(), std::pair(a, b)) != above_.end();
    };
    for (const auto& [a, b] : overlaps(probes)) {
      if (known(a, b) || known(b, a) || probes[a].surroundings || probes[b].surroundings) continue;
      if (probes[a].room == probes[b].room) {
        if (probes[a].part != probes[b].part) above.emplace_back(probes[a].part ? b : a, probes[a].part ? a : b);
        continue;
      }
      std::vector<Probe> two = {probes[a].probe, probes[b].probe};
      const std::size_t ofA = probes[a].room, ofB = probes[b].room;
      const auto errorWith = [&](double importanceA, double importanceB) {
        two[0].importance = importanceA;
        two[1].importance = importanceB;
        double error = 0.0;
        for (const std::size_t room : {ofA, ofB}) {
          error += rooms_.rooms[room].volume * litErrors(fitter_, rating_->rays[room], two).meanDegrees;
        }
        return error;
      };
      const double alike = errorWith(1, 1), first = errorWith(2, 1), second = errorWith(1, 2);
      if (std::min(first, second) > 0.99 * alike) continue;
      first < second ? above.emplace_back(b, a) : above.emplace_back(a, b);
    }
    for (PlacedProbe& placed : probes) placed.probe.importance = placed.surroundings ? 0.0 : 1.0;
    for (const Probe& kept : placement_.kept) {
      for (PlacedProbe& placed : probes) {
        if (placed.surroundings) placed.probe.importance = std::min(placed.probe.importance, kept.importance - 1.0);
      }
    }
    for (std::size_t round = 0; round < above.size() && round < kMostRanks; ++round) {
      for (const auto& [low, high] : above) {
        double& importance = probes[high].probe.importance;
        importance = std::max(importance, std::min(probes[low].probe.importance, 1.0 * kMostRanks) + 1.0);
      }
    }
  }

  bool judge() {
    coverSeen();
    setImportance();
    for (std::size_t i = 0; i < placement_.rooms.size(); ++i) {
      if (!part(0.95, 0.98)(static_cast<double>(i) / roomCount())) return false;
      placement_.rooms[i].before = litErrors(fitter_, rating_->rays[i], scene_.probes);
    }
    placement_.before = overRooms(placement_.rooms, &PlacedRoom::before);
    if (!placement_.rooms.empty()) placement_.rating = rating_;
    placement_.rate();
    return true;
  }

  /// The deepest cell, and of those half as deep the one nearest to the middle.
  std::vector<glm::dvec3> originsIn(const Room& room) const {
    const FreeSpace& space = rooms_.space;
    const auto deeper = [&](std::size_t a, std::size_t b) { return space.depth[a] < space.depth[b]; };
    const std::size_t deepest = *std::max_element(room.cells.begin(), room.cells.end(), deeper);
    std::size_t middle = deepest;
    double nearest = 1e300;
    for (const std::size_t cell : room.cells) {
      const double away = glm::length(space.gridPosition(cell) - room.extent.center());
      if (space.depth[cell] >= 0.5f * space.depth[deepest] && away < nearest) middle = cell, nearest = away;
    }
    return {space.worldPosition(deepest), space.worldPosition(middle)};
  }

  void finish() {
    std::stable_sort(placement_.probes.begin(), placement_.probes.end(),
                     [](const PlacedProbe& a, const PlacedProbe& b) { return a.room < b.room; });
    std::vector<std::size_t> lit = held_;
    for (PlacedProbe& placed : placement_.probes) {
      if (!placed.surroundings) lit.push_back(placed.room);
      inheritSettings(scene_.probes, placed.probe);
    }
    std::vector<std::string> stems = roomsNamedByObjects(scene_, models_, rooms_);
    if (placement_.indoorsAndOutdoors()) {
      for (std::size_t i = 0; i < stems.size(); ++i) {
        if (stems[i].empty() && rooms_.rooms[i].outdoors) stems[i] = "outdoors";
      }
    }
    const std::vector<std::string> names = numberedRooms(stems, lit);
    for (std::size_t i = 0; i < placement_.rooms.size(); ++i) {
      placement_.rooms[i].name = names[i];
      placement_.rooms[i].eyes = eyesIn(captured(), rooms_, rooms_.rooms[i]);
      placement_.rooms[i].origins = originsIn(rooms_.rooms[i]);
    }
    for (PlacedProbe& placed : placement_.probes) {
      const std::string& room = placement_.rooms[placed.room].name;
      if (placed.surroundings) continue;
      const auto sameRoom =
          std::count_if(placement_.probes.begin(), placement_.probes.end(),
                        [&](const PlacedProbe& each) { return each.room == placed.room && !each.surroundings; });
      if (sameRoom == 1) {
        placed.reason = Phrase::tr("the only one of %1").arg(room);
      } else if (!placed.part) {
        placed.reason = Phrase::tr("for all of %1").arg(room);
      } else {
        placed.reason = Phrase::tr("for a part of %1, where it lowers the lookup error by %2 degrees")
                            .arg(room)
                            .arg(decimals(placed.gainDegrees));
      }
    }
    nameProbes(placement_);
  }

  const Scene& scene_;
  const TriangleRays::Models& models_;
  const PlaceSettings& settings_;
  const FitProgress& progress_;
  std::shared_ptr<PlaceRating> rating_;
  ProbeFitter& fitter_;
  Rooms rooms_;
  std::optional<RoomFitter> roomFits_;
  std::vector<std::size_t> roomOf_;                         ///< per cell; the number of rooms: none
  std::vector<std::size_t> held_;                           ///< rooms that contain a probe to keep
  std::vector<std::pair<std::size_t, std::size_t>> above_;  ///< where influences grew: the second above the first
  Placement placement_;
};

}  // namespace

void nameProbes(Placement& placement) {
  Scene named;
  named.probes = placement.kept;
  for (PlacedProbe& placed : placement.probes) {
    if (placed.surroundings) {
      placed.probe.name = unusedProbeName(named, "surroundings");
      named.probes.push_back(placed.probe);
      continue;
    }
    const auto inRoom = [&](const PlacedProbe& each) { return each.room == placed.room && !each.surroundings; };
    const auto sameRoom = std::count_if(placement.probes.begin(), placement.probes.end(), inRoom);
    std::string name = placement.rooms[placed.room].name;
    if (sameRoom > 1) {
      const auto before = std::count_if<const PlacedProbe*>(placement.probes.data(), &placed, inRoom);
      name += before < 26 ? std::string{' ', static_cast<char>('a' + before)} : " " + std::to_string(before + 1);
    }
    placed.probe.name = unusedProbeName(named, name);
    named.probes.push_back(placed.probe);
  }
}

std::vector<Probe> Placement::all() const {
  std::vector<Probe> together = kept;
  for (const PlacedProbe& placed : probes) together.push_back(placed.probe);
  return together;
}

void Placement::rate() {
  if (rating == nullptr) return;
  const std::vector<Probe> together = all();
  for (std::size_t i = 0; i < rooms.size(); ++i) rooms[i].after = litErrors(rating->fitter, rating->rays[i], together);
  after = overRooms(rooms, &PlacedRoom::after);
  bareAfter = bareShare(rating->seen, together);
}

bool Placement::indoorsAndOutdoors() const {
  const auto outdoors = std::count_if(rooms.begin(), rooms.end(), [](const PlacedRoom& room) { return room.outdoors; });
  return outdoors > 0 && static_cast<std::size_t>(outdoors) < rooms.size();
}

std::optional<Placement> placeProbes(const Scene& scene, const TriangleRays::Models& models,
                                     const PlaceSettings& settings, const FitProgress& progress) {
  double furthest = 0.0;
  const FitProgress onward = [&](double done) {
    furthest = std::max(furthest, done);
    return !progress || progress(furthest);
  };
  return Placer(scene, models, settings, onward).place();
}

bool fitSharedRooms(const Scene& scene, const TriangleRays::Models& models, const PlaceSettings& settings,
                    const FitProgress& progress) {
  return Placer(scene, models, settings, progress).fitShare();
}

}  // namespace boxprobe
