#include "data/scenes/home.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "data/scenes/picture.h"
#include "data/scenes/soft_shapes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kReach = 0.8;     // metres: what is farther away hides nothing
constexpr double kStrength = 0.9;  // of what is hidden: light comes off the hiding things as well
constexpr double kOffset = 0.004;  // of the point that looks, from its surface
constexpr double kShrink = 0.002;  // of hiding boxes, so that none hides its own faces
constexpr double kTexel = 0.04;    // of walls' and floors' occlusion
constexpr int kRays = 64;
constexpr double kTwoPi = 6.283185307179586;

double rounded(double value) {
  return std::nearbyint(std::ldexp(value, 20)) * std::ldexp(1.0, -20);
}

/// About +Z, as many per solid angle as light arrives from there on a matt surface.
const std::array<glm::dvec3, kRays>& rays() {
  static const std::array<glm::dvec3, kRays> all = [] {
    std::array<glm::dvec3, kRays> made{};
    for (int i = 0; i < kRays; ++i) {
      const double radius = std::sqrt((i + 0.5) / kRays), angle = 0.381966 * kTwoPi * i;
      made[static_cast<std::size_t>(i)] = {rounded(radius * std::cos(angle)), rounded(radius * std::sin(angle)),
                                           rounded(std::sqrt(1.0 - radius * radius))};
    }
    return made;
  }();
  return all;
}

std::pair<glm::dvec3, glm::dvec3> across(glm::dvec3 normal) {
  const glm::dvec3 other = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(other, normal));
  return {side, glm::cross(normal, side)};
}

Picture ramp() {
  static const Picture made = paintNumbers("occlusion", 128, 4, [](double u, double) { return glm::dvec3(u); });
  return made;
}

TextureUse second(const Picture& picture) {
  TextureUse use{picture, Wrap::ClampToEdge, Wrap::ClampToEdge};
  use.uvSet = 1;
  return use;
}

}  // namespace

void Pen::add(const MeshBuilder& part) const {
  home_.pieces_[piece_].mesh.add(part, placed_);
}

void Pen::box(glm::dvec3 low, glm::dvec3 high, double bevel, double metres) const {
  // Each board from another place of its picture.
  const int i = home_.shift_++;
  add(bevelBox(low, high, bevel, metres, {hash(i, 0, 7), hash(i, 1, 7)}));
  hide(low, high);
}

void Pen::cushion(glm::dvec3 low, glm::dvec3 high, double radius, glm::dvec3 bulge, int cells) const {
  add(scenes::cushion(low, high, radius, bulge, cells, 0.35));
  const glm::dvec3 in = 0.12 * (high - low);
  hide(low + in, high - in);
}

void Pen::hide(glm::dvec3 low, glm::dvec3 high) const {
  home_.hide(placed_, low, high);
}

Pen Home::pen(const std::string& node, int material, const glm::dmat4& placed) {
  std::size_t i = 0;
  while (i < pieces_.size() && (pieces_[i].node != node || pieces_[i].material != material)) ++i;
  if (i == pieces_.size()) pieces_.push_back({node, material, {}});
  return {*this, i, placed};
}

int Home::material(Material material) {
  material.occlusionTexture = second(ramp());
  return composer_.material(std::move(material));
}

int Home::bareMaterial(Material material) {
  bare_.push_back(composer_.material(std::move(material)));
  return bare_.back();
}

int Home::brushedMaterial(Material material) {
  material.finish.anisotropy = 0.7f;
  brushed_.push_back(this->material(std::move(material)));
  return brushed_.back();
}

void Home::surface(const std::string& node, Material material, glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up,
                   const std::vector<double>& rightCuts, const std::vector<double>& upCuts, double metres,
                   const std::function<bool(double, double)>& keep) {
  const double width = glm::length(right), height = glm::length(up);
  const auto fractions = [](std::vector<double> cuts) {
    const double whole = cuts.back();
    for (double& cut : cuts) cut /= whole;
    return cuts;
  };
  const auto kept = [&](std::size_t column, std::size_t row) {
    return !keep || keep(0.5 * (rightCuts[column] + rightCuts[column + 1]), 0.5 * (upCuts[row] + upCuts[row + 1]));
  };
  Surface made{node, std::move(material), {}, corner, right, up};
  made.mesh.quadGrid(
      corner, right, up, fractions(rightCuts), fractions(upCuts), {0.0, 0.0, width / metres, height / metres},
      [&](int column, int row) { return kept(static_cast<std::size_t>(column), static_cast<std::size_t>(row)); });
  surfaces_.push_back(std::move(made));
  const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
  for (std::size_t column = 0; column + 1 < rightCuts.size(); ++column) {
    for (std::size_t row = 0; row + 1 < upCuts.size(); ++row) {
      if (!kept(column, row)) continue;
      const glm::dvec3 a = corner + rightCuts[column] / width * right + upCuts[row] / height * up;
      const glm::dvec3 b =
          corner + rightCuts[column + 1] / width * right + upCuts[row + 1] / height * up - 0.1 * normal;
      hide(glm::dmat4(1.0), glm::min(a, b), glm::max(a, b));
    }
  }
}

void Home::hide(const glm::dmat4& placed, glm::dvec3 low, glm::dvec3 high) {
  Hider hider;
  const glm::dvec3 middle = 0.5 * (low + high);
  hider.half = glm::max(0.5 * (high - low) - kShrink, 1e-4);
  hider.boxFromWorld = glm::inverse(glm::translate(placed, middle));
  hider.middle = glm::dvec3(placed * glm::dvec4(middle, 1.0));
  hider.reach = glm::length(hider.half);
  hiders_.push_back(hider);
}

std::vector<const Home::Hider*> Home::hidersNear(glm::dvec3 low, glm::dvec3 high) const {
  std::vector<const Hider*> near;
  for (const Hider& hider : hiders_)
    if (glm::length(hider.middle - glm::clamp(hider.middle, low, high)) < hider.reach + kReach) near.push_back(&hider);
  return near;
}

// How open it is about a point: 1 where nothing is within reach, less the nearer things are.
double Home::openness(glm::dvec3 at, glm::dvec3 normal, const std::vector<const Hider*>& near) const {
  const auto [side, other] = across(normal);
  const glm::dvec3 from = at + kOffset * normal;
  struct Local {
    glm::dvec3 from;
    const Hider* hider;
  };
  std::vector<Local> locals;
  for (const Hider* hider : near) {
    const glm::dvec3 p(hider->boxFromWorld * glm::dvec4(from, 1.0));
    const glm::dvec3 off = glm::max(glm::abs(p) - hider->half, 0.0);
    if (glm::dot(off, off) < kReach * kReach) locals.push_back({p, hider});
  }
  double hidden = 0.0;
  for (const glm::dvec3& ray : rays()) {
    const glm::dvec3 direction = ray.x * side + ray.y * other + ray.z * normal;
    double nearest = kReach;
    for (const Local& local : locals) {
      const glm::dvec3 d = glm::dmat3(local.hider->boxFromWorld) * direction;
      double enters = 0.0, leaves = nearest;
      for (int axis = 0; axis < 3 && enters < leaves; ++axis) {
        const double h = local.hider->half[axis], p = local.from[axis];
        if (std::abs(d[axis]) < 1e-9) {
          if (std::abs(p) > h) leaves = -1.0;
          continue;
        }
        const double a = (-h - p) / d[axis], b = (h - p) / d[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
      }
      if (enters < leaves) nearest = enters;
    }
    const double t = nearest / kReach;
    hidden += (1.0 - t) * (1.0 - t);
  }
  return std::nearbyint(256.0 * (1.0 - kStrength * hidden / kRays)) / 256.0;
}

Model Home::finish() && {
  for (Surface& surface : surfaces_) {
    const double width = glm::length(surface.right), height = glm::length(surface.up);
    const glm::dvec3 normal = glm::normalize(glm::cross(surface.right, surface.up));
    const glm::dvec3 opposite = surface.corner + surface.right + surface.up;
    const auto near = hidersNear(glm::min(surface.corner, opposite), glm::max(surface.corner, opposite));
    const Picture open = paintNumbers(
        "occlusion of " + surface.node, static_cast<int>(std::ceil(width / kTexel)),
        static_cast<int>(std::ceil(height / kTexel)), [&](double u, double v) {
          return glm::dvec3(openness(surface.corner + u * surface.right + (1.0 - v) * surface.up, normal, near));
        });
    surface.material.occlusionTexture = second(open);
    Mesh mesh = std::move(surface.mesh).finish(surface.node, composer_.material(surface.material));
    for (const glm::vec3& p : mesh.positions) {
      const glm::dvec3 off = glm::dvec3(p) - surface.corner;
      mesh.uv1.emplace_back(rounded(glm::dot(off, surface.right) / (width * width)),
                            rounded(1.0 - glm::dot(off, surface.up) / (height * height)));
    }
    composer_.place(surface.node, composer_.mesh(std::move(mesh)));
  }
  for (Piece& piece : pieces_) {
    Mesh mesh = std::move(piece.mesh).finish(piece.node, piece.material);
    const auto in = [&piece](const std::vector<int>& list) {
      return std::find(list.begin(), list.end(), piece.material) != list.end();
    };
    if (!in(bare_)) {
      glm::vec3 low = mesh.positions.front(), high = low;
      for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
      const auto near = hidersNear(glm::dvec3(low), glm::dvec3(high));
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double open = openness(glm::dvec3(mesh.positions[i]), glm::normalize(glm::dvec3(mesh.normals[i])), near);
        mesh.uv1.emplace_back(static_cast<float>(open), 0.5f);
      }
    }
    if (in(brushed_)) {
      for (const glm::vec3& normal : mesh.normals) {
        const glm::dvec3 side = across(glm::normalize(glm::dvec3(normal))).first;
        mesh.tangents.emplace_back(rounded(side.x), rounded(side.y), rounded(side.z), 1.0f);
      }
    }
    composer_.place(piece.node, composer_.mesh(std::move(mesh)));
  }
  return std::move(composer_).finish();
}

}  // namespace boxprobe::scenes
