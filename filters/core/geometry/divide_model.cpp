#include "filters/core/geometry/divide_model.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

constexpr int kDeepest = 8;  // at most 256 pieces per object
constexpr int kCuts = 16;    // a cut is one of the planes at sixteenths of a box

Box worldBoundsOf(const Mesh& mesh, const glm::dmat4& worldFromModel) {
  Box box;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 p(worldFromModel * glm::dvec4(mesh.positions[i], 1.0));
    box = i == 0 ? Box{p, p} : Box{glm::min(box.min, p), glm::max(box.max, p)};
  }
  return box;
}

/// The number of probes that compete for a box: all but those less important than a probe that covers it.
std::size_t competing(const std::vector<Probe>& probes, const ProbeIndex& index, const Box& box) {
  const std::vector<std::size_t> meeting = index.meeting(box);
  double least = -1.0e300;
  for (const std::size_t i : meeting) {
    if (fullWeightEverywhere(probes[i], box)) least = std::max(least, probes[i].importance);
  }
  return static_cast<std::size_t>(
      std::count_if(meeting.begin(), meeting.end(), [&](std::size_t i) { return probes[i].importance >= least; }));
}

/// One half of a mesh: copies the vertices that its triangles use.
class Half {
 public:
  Half(const Mesh& from, Mesh& to) : from_(from), to_(to), known_(from.positions.size(), kNone) {
    to.name = from.name;
    to.material = from.material;
  }
  std::uint32_t vertex(std::uint32_t i) {
    if (known_[i] == kNone) {
      known_[i] = add(from_.positions[i]);
      if (!from_.normals.empty()) to_.normals.push_back(from_.normals[i]);
      if (!from_.tangents.empty()) to_.tangents.push_back(from_.tangents[i]);
      if (!from_.uv.empty()) to_.uv.push_back(from_.uv[i]);
      if (!from_.uv1.empty()) to_.uv1.push_back(from_.uv1[i]);
      if (!from_.colors.empty()) to_.colors.push_back(from_.colors[i]);
    }
    return known_[i];
  }
  /// The vertex a fraction `t` along the edge from i to j, with i < j so that both triangles at the edge make the same.
  std::uint32_t between(std::uint32_t i, std::uint32_t j, double t) {
    const auto found = cut_.find({i, j});
    if (found != cut_.end()) return found->second;
    const auto mix = [t](const auto& a, const auto& b) { return a + static_cast<float>(t) * (b - a); };
    const std::uint32_t made = add(mix(from_.positions[i], from_.positions[j]));
    if (!from_.normals.empty()) {
      const glm::vec3 n = mix(from_.normals[i], from_.normals[j]);
      to_.normals.push_back(glm::dot(n, n) > 0.0f ? glm::normalize(n) : from_.normals[i]);
    }
    if (!from_.tangents.empty()) {
      const glm::vec3 tangent = mix(glm::vec3(from_.tangents[i]), glm::vec3(from_.tangents[j]));
      to_.tangents.emplace_back(glm::dot(tangent, tangent) > 0.0f ? glm::normalize(tangent) : tangent,
                                from_.tangents[i].w);
    }
    if (!from_.uv.empty()) to_.uv.push_back(mix(from_.uv[i], from_.uv[j]));
    if (!from_.uv1.empty()) to_.uv1.push_back(mix(from_.uv1[i], from_.uv1[j]));
    if (!from_.colors.empty()) to_.colors.push_back(mix(from_.colors[i], from_.colors[j]));
    cut_[{i, j}] = made;
    return made;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { to_.indices.insert(to_.indices.end(), {a, b, c}); }

 private:
  static constexpr std::uint32_t kNone = ~0u;
  std::uint32_t add(const glm::vec3& position) {
    to_.positions.push_back(position);
    return static_cast<std::uint32_t>(to_.positions.size() - 1);
  }
  const Mesh& from_;
  Mesh& to_;
  std::vector<std::uint32_t> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cut_;
};

class Divider {
 public:
  Divider(const std::vector<Probe>& probes, const ProbeIndex& index, std::size_t most)
      : probes_(probes), index_(index), most_(most) {}

  void divide(Mesh mesh, const glm::dmat4& worldFromModel, int depth, std::vector<Mesh>& pieces) const {
    const Box box = worldBoundsOf(mesh, worldFromModel);
    const double here = leftOut(box);
    if (here > 0.0 && depth < kDeepest) {
      if (const auto cut = bestCut(box, here)) {
        MeshHalves halves = cutMesh(mesh, worldFromModel, cut->first, cut->second);
        if (!halves.below.indices.empty() && !halves.above.indices.empty()) {
          divide(std::move(halves.below), worldFromModel, depth + 1, pieces);
          divide(std::move(halves.above), worldFromModel, depth + 1, pieces);
          return;
        }
      }
    }
    pieces.push_back(std::move(mesh));
  }

 private:
  /// The axis and position of the cut after which the fewest probes are left out, counted by how much of the box they
  /// are left out of; of equal ones that with the larger halves. Nothing if none is better than no cut. Positions are a
  /// sixteenth of the box apart, so that pieces stay the same while a probe's face is dragged from one to the next.
  std::optional<std::pair<int, double>> bestCut(const Box& box, double here) const {
    std::optional<std::pair<int, double>> best;
    double least = (1.0 - 1.0e-9) * here, widest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = box.size()[axis];
      if (!(size > 0.0)) continue;
      for (int step = 1; step < kCuts; ++step) {
        const double share = static_cast<double>(step) / kCuts;
        Box low = box, high = box;
        low.max[axis] = high.min[axis] = box.min[axis] + share * size;
        const double left = share * leftOut(low) + (1.0 - share) * leftOut(high);
        const double wide = std::min(share, 1.0 - share) * size;
        if (left > least || (left == least && wide <= widest)) continue;
        best = {axis, low.max[axis]};
        least = left;
        widest = wide;
      }
    }
    return best;
  }

  double leftOut(const Box& box) const {
    const std::size_t here = competing(probes_, index_, box);
    return here > most_ ? static_cast<double>(here - most_) : 0.0;
  }

  const std::vector<Probe>& probes_;
  const ProbeIndex& index_;
  std::size_t most_;
};

}  // namespace

MeshHalves cutMesh(const Mesh& mesh, const glm::dmat4& worldFromModel, int axis, double at) {
  MeshHalves halves;
  Half below(mesh, halves.below), above(mesh, halves.above);
  std::vector<double> side(mesh.positions.size());
  for (std::size_t i = 0; i < side.size(); ++i) {
    side[i] = glm::dvec3(worldFromModel * glm::dvec4(mesh.positions[i], 1.0))[axis] - at;
  }
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::array<std::uint32_t, 3> v = {mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]};
    const bool allBelow = side[v[0]] <= 0.0 && side[v[1]] <= 0.0 && side[v[2]] <= 0.0;
    const bool allAbove = side[v[0]] >= 0.0 && side[v[1]] >= 0.0 && side[v[2]] >= 0.0;
    if (allBelow || allAbove) {
      Half& half = allBelow ? below : above;
      half.triangle(half.vertex(v[0]), half.vertex(v[1]), half.vertex(v[2]));
      continue;
    }
    for (const bool lower : {true, false}) {
      Half& half = lower ? below : above;
      std::vector<std::uint32_t> polygon;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = v[k], b = v[(k + 1) % 3];
        const double da = side[a], db = side[b];
        if (lower ? da <= 0.0 : da >= 0.0) polygon.push_back(half.vertex(a));
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) {
          const std::uint32_t i = std::min(a, b), j = std::max(a, b);
          polygon.push_back(half.between(i, j, side[i] / (side[i] - side[j])));
        }
      }
      for (std::size_t k = 2; k < polygon.size(); ++k) half.triangle(polygon[0], polygon[k - 1], polygon[k]);
    }
  }
  return halves;
}

std::shared_ptr<const Model> dividedModel(std::shared_ptr<const Model> model, const glm::dmat4& worldFromModel,
                                          const std::vector<Probe>& probes, const ProbeIndex& index, std::size_t most) {
  if (probes.size() <= most) return model;
  const Divider divider(probes, index, most);
  std::shared_ptr<Model> divided;
  std::vector<Instance> instances;
  for (const Instance& instance : model->instances) {
    const Mesh& mesh = model->meshes[static_cast<std::size_t>(instance.mesh)];
    const bool lit = mesh.material < 0 || !model->materials[static_cast<std::size_t>(mesh.material)].unlit;
    const glm::dmat4 placed = worldFromModel * instance.worldFromModel;
    if (!lit || competing(probes, index, worldBoundsOf(mesh, placed)) <= most) {
      instances.push_back(instance);
      continue;
    }
    std::vector<Mesh> pieces;
    divider.divide(mesh, placed, 0, pieces);
    if (pieces.size() == 1) {
      instances.push_back(instance);
      continue;
    }
    if (!divided) divided = std::make_shared<Model>(*model);
    for (Mesh& piece : pieces) {
      Instance part = instance;
      part.mesh = static_cast<int>(divided->meshes.size());
      divided->meshes.push_back(std::move(piece));
      instances.push_back(std::move(part));
    }
  }
  if (!divided) return model;
  divided->instances = std::move(instances);
  return divided;
}

}  // namespace boxprobe
