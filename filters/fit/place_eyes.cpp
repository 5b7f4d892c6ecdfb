// See place_eyes.h.
#include "filters/fit/place_eyes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "filters/math/sampling/van_der_corput.h"

namespace boxprobe {

namespace {

constexpr std::size_t kRoomEyes = 12, kMostPlaces = 300;
constexpr int kYaws = 12;
constexpr double kClearance = 0.08;  // of the room's height: nothing closer

struct Place {
  glm::dvec3 eye{0.0};
  double height = 0.0;
};

std::vector<Place> placesIn(const SurfaceRays& rays, const FreeSpace& space, const Room& room) {
  const glm::dvec3 up(0.0, 1.0, 0.0);
  std::vector<Place> places;
  const std::size_t stride = std::max<std::size_t>(1, room.cells.size() / kMostPlaces);
  for (std::size_t i = 0; i < room.cells.size(); i += stride) {
    const glm::dvec3 from = space.worldPosition(room.cells[i]);
    const std::optional<SurfaceHit> below = rays.first(from, -up), above = rays.first(from, up);
    if (!below) continue;
    const double height = above ? below->distance + above->distance : room.extent.size().y;
    const double tall = 1.2 + 0.6 * vanDerCorput(static_cast<int>(places.size()) + 1, 2);
    const double lift = std::clamp(tall, 0.3 * height, 0.65 * height) - below->distance;
    // Up or down from the cell, if nothing is between.
    if (lift > 0.0 && above && lift > above->distance - kClearance * height) continue;
    const glm::dvec3 eye = from + lift * up;
    double nearest = kClearance * height;
    for (const glm::dvec3& along : fibonacciDirections(24)) {
      const std::optional<SurfaceHit> hit = rays.first(eye, along);
      if (hit) nearest = std::min(nearest, hit->distance);
    }
    if (nearest < kClearance * height || height < 0.6 * room.extent.size().y) continue;  // not under a table
    places.push_back({eye, height});
  }
  return places;
}

}  // namespace

std::vector<Camera> eyesIn(const SurfaceRays& rays, const Rooms& rooms, const Room& room) {
  const std::vector<Place> places = placesIn(rays, rooms.space, room);
  std::vector<Camera> eyes;
  std::vector<glm::dvec3> looks;
  // The first one is near the middle: far from it are corners, niches and what is barely within the room.
  std::vector<double> away;
  const glm::dvec3 middle = rooms.space.worldFromGrid * room.extent.center();
  for (const Place& place : places) away.push_back(1e12 - glm::length(place.eye - middle));
  while (eyes.size() < kRoomEyes && !places.empty()) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (away[i] > away[next]) next = i;
    }
    const Place& place = places[next];
    if (!(away[next] > 0.2 * place.height)) break;
    glm::dvec3 best(0.0);
    double most = -1.0;
    for (int k = 0; k < kYaws; ++k) {
      const double yaw = 6.283185307179586 * (k + 0.37) / kYaws;
      const glm::dvec3 along = glm::normalize(glm::dvec3(std::cos(yaw), -0.18, std::sin(yaw)));
      const std::optional<SurfaceHit> hit = rays.first(place.eye, along);
      double worth = std::min(hit ? hit->distance : 0.0, 3.0 * place.height);
      for (const glm::dvec3& look : looks) worth *= 1.0 - 0.5 * std::max(glm::dot(look, along), 0.0);
      if (worth > most) most = worth, best = along;
    }
    Camera eye;
    eye.name = "eye " + std::to_string(eyes.size() + 1);
    eye.position = place.eye;
    eye.target = place.eye + place.height * best;
    eye.verticalFovDegrees = 65.0;
    eyes.push_back(eye);
    looks.push_back(best);
    for (std::size_t i = 0; i < places.size(); ++i) {
      away[i] = std::min(away[i], glm::length(places[i].eye - place.eye));
    }
  }
  return eyes;
}

}  // namespace boxprobe
