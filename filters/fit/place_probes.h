// Places probes for a whole model: finds its rooms, fits a box to each, and adds probes to a room while they gain.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"
#include "filters/fit/lit_errors.h"
#include "filters/fit/place_cover.h"
#include "filters/fit/placed_probe.h"
#include "filters/fit/rooms/find_rooms.h"
#include "filters/fit/shared_fits.h"

namespace boxprobe {

struct PlaceSettings {
  std::size_t most = 64;    ///< maximum number of probes, including those kept
  double leastGain = 0.02;  ///< minimum gain of a further probe in a room, relative to what its probes gain in total
  bool keep = false;        ///< keep the scene's probes; rooms that contain one get no other
  bool inverted = false;    ///< allow back faces as walls, even if no camera is among them
  int rays = 4096;          ///< per fit
  const SharedFits* shared = nullptr;  ///< takes over fits that other processes made; null: all are made here
};

/// A room in the report.
struct PlacedRoom {
  std::string name;  ///< "kitchen" if its objects are called so, else "room 1"; "outdoors" beside rooms with a ceiling
  Box extent;        ///< of its free space, along axes rotated by `yawDegrees` about the world's +y axis
  double yawDegrees = 0.0;
  glm::dvec3 middleWorld{0.0};
  double volume = 0.0;
  std::vector<Doorway> doorways;    ///< `a` is this room
  bool outdoors = false;            ///< a court or garden
  bool reflects = true;             ///< false: it has no ceiling and only rough surfaces, and is ignored
  std::size_t parts = 1;            ///< number of parts between narrow places
  LitErrors before, after;          ///< with the scene's own probes; with the placed probes
  std::vector<Camera> eyes;         ///< of people standing in it, 1.2 to 1.8 m above the floor, far from each other
  std::vector<glm::dvec3> origins;  ///< free places for a capture: far from surfaces, and near the middle
  std::vector<Phrase> decisions;    ///< sentences without a full stop: every probe that was tried, and the result
};

/// What people in the rooms see, by which probes are rated.
struct PlaceRating {
  ProbeFitter fitter;
  std::vector<ReflectedRays> rays;  ///< one per room
  std::vector<SeenPlace> seen;      ///< from rooms that reflect
};

struct Placement {
  std::vector<PlacedRoom> rooms;             ///< in order of decreasing size
  std::vector<PlacedProbe> probes;           ///< in the order of the rooms
  std::vector<Probe> kept;                   ///< of the scene; all of them if there are no rooms
  LitErrors before, after;                   ///< of all rooms, weighted by volume
  double bareBefore = 0.0, bareAfter = 0.0;  ///< share of what is seen from the rooms that no probe lights
  std::vector<Phrase> remarks;
  double cell = 0.0;  ///< cell size of the free space, scene units
  std::size_t cells = 0;
  double roomSeconds = 0.0, seconds = 0.0;
  std::shared_ptr<PlaceRating> rating;  ///< null without rooms

  /// Are there rooms of both kinds? No box then goes around all of them.
  bool indoorsAndOutdoors() const;
  /// The kept probes and the placed ones.
  std::vector<Probe> all() const;
  /// Sets `after` of all and of each room, and `bareAfter`, to what all() leaves. To be called by whoever changes the
  /// probes after placeProbes().
  void rate();
};

/// Probes are called as their rooms, with a letter where a room has several; no name is one of `placement.kept`. Called
/// by placeProbes(), and again by whoever leaves probes out.
void nameProbes(Placement& placement);

/// Rated for people standing in the rooms, not for the scene's cameras. Deterministic. Nothing if `progress` stopped
/// it. Throws WorkError if the ray tracer cannot take the models.
std::optional<Placement> placeProbes(const Scene& scene, const TriangleRays::Models& models,
                                     const PlaceSettings& settings = {}, const FitProgress& progress = {});

/// Makes and keeps this process's share of the rooms' fits, `settings.shared` says which, and nothing else. False if
/// `progress` stopped it. Throws as placeProbes() does.
bool fitSharedRooms(const Scene& scene, const TriangleRays::Models& models, const PlaceSettings& settings,
                    const FitProgress& progress = {});

}  // namespace boxprobe
