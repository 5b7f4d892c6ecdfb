// See room_names.h.
#include "filters/fit/room_names.h"

#include <algorithm>
#include <cctype>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>

#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

struct RoomWord {
  const char* word;  ///< as in names, lower case, words separated by a space
  const char* room;
};

constexpr RoomWord kRoomWords[] = {
    {"kitchen", "kitchen"},        {"bathroom", "bathroom"},   {"bath room", "bathroom"},
    {"bedroom", "bedroom"},        {"bed room", "bedroom"},    {"living room", "living room"},
    {"livingroom", "living room"}, {"lounge", "lounge"},       {"dining room", "dining room"},
    {"diningroom", "dining room"}, {"hallway", "hallway"},     {"corridor", "corridor"},
    {"toilet", "toilet"},          {"wc", "toilet"},           {"study", "study"},
    {"garage", "garage"},          {"pantry", "pantry"},       {"laundry", "laundry"},
    {"nursery", "nursery"},        {"library", "library"},     {"lobby", "lobby"},
    {"classroom", "classroom"},    {"attic", "attic"},         {"basement", "basement"},
    {"cellar", "cellar"},          {"staircase", "staircase"}, {"balcony", "balcony"},
    {"workshop", "workshop"},      {"office", "office"},       {"garden", "garden"},
    {"terrace", "terrace"},        {"patio", "patio"},         {"courtyard", "courtyard"}};

/// " living room sofa " for "LivingRoom_Sofa.001".
std::string words(const std::string& name) {
  std::string text = " ";
  bool lower = false;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalpha(c) == 0) {
      if (text.back() != ' ') text += ' ';
      lower = false;
      continue;
    }
    if (lower && std::isupper(c) != 0) text += ' ';
    lower = std::islower(c) != 0;
    text += static_cast<char>(std::tolower(c));
  }
  if (text.back() != ' ') text += ' ';
  return text;
}

/// The middle of a mesh as the file has it.
std::optional<glm::dvec3> middleOf(const Mesh& mesh) {
  if (mesh.positions.empty()) return std::nullopt;
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::vec3& p : mesh.positions) low = glm::min(low, glm::dvec3(p)), high = glm::max(high, glm::dvec3(p));
  return 0.5 * (low + high);
}

}  // namespace

std::string roomNamedBy(const std::string& node) {
  const std::string text = words(node);
  for (const RoomWord& each : kRoomWords) {
    if (text.find(' ' + std::string(each.word) + ' ') != std::string::npos) return each.room;
  }
  return {};
}

std::vector<std::size_t> roomOfCells(const Rooms& rooms) {
  std::vector<std::size_t> roomOf(rooms.space.depth.size(), rooms.rooms.size());
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    for (const std::size_t cell : rooms.rooms[i].cells) roomOf[cell] = i;
  }
  return roomOf;
}

std::optional<std::size_t> cellAt(const FreeSpace& space, const glm::dvec3& world) {
  const glm::dvec3 at = (glm::transpose(space.worldFromGrid) * world - space.first) / space.cell;
  const glm::ivec3 cell(glm::round(at));
  for (int axis = 0; axis < 3; ++axis) {
    if (!(at[axis] > -0.5) || cell[axis] >= space.count[axis]) return std::nullopt;
  }
  return space.index(cell);
}

std::vector<std::string> roomsNamedByObjects(const Scene& scene, const TriangleRays::Models& models,
                                             const Rooms& rooms) {
  std::vector<std::map<std::string, int>> votes(rooms.rooms.size());
  const std::vector<std::size_t> roomOf = roomOfCells(rooms);
  for (std::size_t m = 0; m < models.size() && m < scene.models.size(); ++m) {
    const glm::dmat4 worldFromModel = worldFromFile(scene.models[m]);
    for (const Instance& instance : models[m]->instances) {
      const std::string room = roomNamedBy(instance.node);
      if (room.empty()) continue;
      const auto middle = middleOf(models[m]->meshes[static_cast<std::size_t>(instance.mesh)]);
      if (!middle) continue;
      const glm::dvec3 at(worldFromModel * instance.worldFromModel * glm::dvec4(*middle, 1.0));
      // The middle of a floor or ceiling is in no cell: the air above it or below is.
      for (const double up : {0.0, 0.15, -0.15, 0.3, -0.3, 0.5, -0.5}) {
        const auto cell = cellAt(rooms.space, at + glm::dvec3(0.0, up * rooms.region.height, 0.0));
        if (!cell || roomOf[*cell] == rooms.rooms.size()) continue;
        ++votes[roomOf[*cell]][room];
        break;
      }
    }
  }
  std::vector<std::string> names(rooms.rooms.size());
  for (std::size_t i = 0; i < votes.size(); ++i) {
    int all = 0, most = 0;
    for (const auto& [name, count] : votes[i]) {
      all += count;
      if (count > most) most = count, names[i] = name;
    }
    if (2 * most <= all) names[i].clear();
  }
  return names;
}

std::vector<std::string> numberedRooms(const std::vector<std::string>& names, const std::vector<std::size_t>& probes) {
  std::vector<std::string> numbered(names.size());
  std::map<std::string, int> count, next;
  for (const std::string& name : names) ++count[name];
  for (const bool lit : {true, false}) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if ((std::find(probes.begin(), probes.end(), i) != probes.end()) != lit) continue;
      const std::string stem = names[i].empty() ? "room" : names[i];
      const int number = ++next[names[i]];
      numbered[i] = names[i].empty() || count[names[i]] > 1 ? stem + " " + std::to_string(number) : stem;
    }
  }
  return numbered;
}

}  // namespace boxprobe
