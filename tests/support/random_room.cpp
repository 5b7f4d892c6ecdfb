// See random_room.h.
#include "tests/support/random_room.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <vector>

namespace boxprobe::test {

namespace {

enum Look { kFloor, kWall, kCeiling, kWood, kCloth, kMetal, kMirror, kGround, kLooks };

/// Of a wall's rectangle, metres along its two sides.
struct Hole {
  double u0, v0, u1, v1;
};

struct Piece {  ///< of furniture: a block that turns about +y
  glm::dvec3 middle, half;
  double angle;
  bool holds(const glm::dvec3& p, double margin) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 q = p - middle;
    return std::abs(c * q.x - s * q.z) < half.x + margin && std::abs(q.y) < half.y + margin &&
           std::abs(s * q.x + c * q.z) < half.z + margin;
  }
};

class Maker {
 public:
  explicit Maker(std::uint32_t seed) : random_(seed * 7919u + 17u), feature_(seed % 8) {
    model_.meshes.resize(kLooks);
    model_.materials.resize(kLooks);
    for (int look = 0; look < kLooks; ++look) {
      model_.meshes[static_cast<std::size_t>(look)].material = look;
      set(look, 0.9f, 0.0f);
    }
    set(kFloor, static_cast<float>(between(0.05, 0.45)), 0.0f);
    set(kWood, static_cast<float>(between(0.2, 0.7)), 0.0f);
    set(kMetal, static_cast<float>(between(0.1, 0.4)), 1.0f);
    set(kMirror, 0.0f, 1.0f);
  }

  RandomRoom make() {
    const bool tall = feature_ == 6;
    w_ = between(2.6, 9.0);
    d_ = between(2.6, 9.0);
    h_ = tall ? between(4.5, 8.0) : between(2.3, 3.4);
    slope_ = feature_ == 4 || (feature_ == 7 && chance(0.4)) ? between(0.8, 2.5) : 0.0;
    openSide_ = feature_ == 3 || (feature_ == 7 && slope_ == 0.0 && chance(0.4));
    leg_ = feature_ == 2;
    windows_ = feature_ == 1 || feature_ == 6 || feature_ == 7 || chance(0.3);
    const bool turned = feature_ == 5 || feature_ == 7 || chance(0.3);
    const double yaw = turned ? between(-44.0, 44.0) : 0.0;
    shell();
    const int pieces = static_cast<int>(between(0.0, 10.99));
    for (int i = 0; i < pieces; ++i) furnish();
    if (chance(0.3)) {  // a mirror on the wall at -z
      const double x = between(-0.3, 0.1) * w_;
      quad(kMirror, {x, 0.4, -0.5 * d_ + 0.03}, {between(0.5, 1.5), 0, 0}, {0, 1.6, 0});
    }
    if (chance(0.3)) {  // the ground outside
      quad(kGround, {-40, -0.05, 40}, {80, 0, 0}, {0, 0, -80});
    }

    RandomRoom room;
    room.yawDegrees = yaw;
    room.halfSize = 0.5 * glm::dvec3(w_, h_, d_);
    const glm::dvec3 place(between(-20, 20), between(-1, 4), between(-20, 20));
    const glm::dmat4 world =
        glm::rotate(glm::translate(glm::dmat4(1.0), place), glm::radians(yaw), glm::dvec3(0.0, 1.0, 0.0));
    const auto toWorld = [&](const glm::dvec3& p) { return glm::dvec3(world * glm::dvec4(p, 1.0)); };
    for (int look = 0; look < kLooks; ++look) {
      if (model_.meshes[static_cast<std::size_t>(look)].indices.empty()) continue;
      model_.instances.push_back({"part " + std::to_string(look), look, world});
    }
    room.scene.models = {{"random.glb"}};
    Probe probe;
    probe.origin = toWorld(freePoint(chance(0.25) ? 0.3 : 1.0, 1.7, 0.7));
    probe.box = {probe.origin - 1.0, probe.origin + 1.0};
    room.scene.probes = {probe};
    const int cameras = static_cast<int>(between(0.0, 3.99));
    for (int i = 0; i < cameras; ++i) {
      Camera camera;
      camera.name = "camera " + std::to_string(i);
      camera.position = toWorld(freePoint(1.2, 1.8, 0.9));
      camera.target = toWorld(freePoint(0.0, 1.2, 0.9));
      camera.verticalFovDegrees = between(40, 70);
      room.scene.cameras.push_back(camera);
    }
    room.what = leg_ ? "L-shape" : openSide_ ? "open side" : slope_ > 0.0 ? "sloped" : tall ? "tall" : "box";
    if (windows_) room.what += ", windows";
    if (turned) room.what += ", turned";
    room.what += ", " + std::to_string(pieces) + " pieces";
    room.model = std::make_shared<const Model>(std::move(model_));
    return room;
  }

 private:
  double between(double low, double high) {
    // Not std::uniform_real_distribution: its values differ between libraries.
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  void set(int look, float roughness, float metallic) {
    Material& material = model_.materials[static_cast<std::size_t>(look)];
    material.roughness = roughness;
    material.metallic = metallic;
    material.baseColor = glm::vec4(glm::vec3(0.7f), 1.0f);
  }

  /// Its front is on the side of cross(u, v).
  void quad(Look look, const glm::dvec3& a, const glm::dvec3& u, const glm::dvec3& v) {
    quad(look, a, a + u, a + u + v, a + v);
  }
  void quad(Look look, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    Mesh& mesh = model_.meshes[static_cast<std::size_t>(look)];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& p : {a, b, c, d}) mesh.positions.emplace_back(p);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }

  /// A wall from `a` along unit vectors u and v, with holes.
  void wall(const glm::dvec3& a, const glm::dvec3& u, double length, double height, const std::vector<Hole>& holes) {
    std::vector<double> us = {0.0, length}, vs = {0.0, height};
    for (const Hole& hole : holes) {
      us.insert(us.end(), {hole.u0, hole.u1});
      vs.insert(vs.end(), {hole.v0, hole.v1});
    }
    std::sort(us.begin(), us.end());
    std::sort(vs.begin(), vs.end());
    for (std::size_t i = 0; i + 1 < us.size(); ++i) {
      for (std::size_t k = 0; k + 1 < vs.size(); ++k) {
        const double mu = 0.5 * (us[i] + us[i + 1]), mv = 0.5 * (vs[k] + vs[k + 1]);
        const bool open = std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
          return mu > hole.u0 && mu < hole.u1 && mv > hole.v0 && mv < hole.v1;
        });
        if (!open)
          quad(kWall, a + us[i] * u + glm::dvec3(0, vs[k], 0), (us[i + 1] - us[i]) * u, {0, vs[k + 1] - vs[k], 0});
      }
    }
  }

  std::vector<Hole> someHoles(double length) {
    std::vector<Hole> holes;
    if (length < 2.2) return holes;
    if (windows_ && chance(0.5)) {
      const double size = between(0.8, 0.6 * length), u = between(0.2, length - size - 0.2), low = between(0.1, 1.0);
      holes.push_back({u, low, u + size, std::min(low + between(0.8, 1.6), h_ - 0.15)});
    } else if (chance(0.25)) {  // a doorway, some with a corridor behind it
      const double u = between(0.3, length - 1.2);
      holes.push_back({u, 0.0, u + 0.9, 2.0});
    }
    return holes;
  }

  void corridor(const glm::dvec3& a, const glm::dvec3& u, const glm::dvec3& out, double length) {
    const double depth = between(1.2, 4.0), height = 2.2;
    quad(kFloor, a, depth * out, length * u);
    quad(kCeiling, a + glm::dvec3(0, height, 0), length * u, depth * out);
    quad(kWall, a + depth * out, length * u, {0, height, 0});
  }

  void side(const glm::dvec3& a, const glm::dvec3& u, double length, double height) {
    const std::vector<Hole> holes = someHoles(length);
    wall(a, u, length, height, holes);
    if (!holes.empty() && holes[0].v0 == 0.0 && chance(0.6)) {
      corridor(a, u, glm::cross(u, glm::dvec3(0, -1, 0)), length);
    }
  }

  void shell() {
    const double x = 0.5 * w_, z = 0.5 * d_, top = h_ + slope_;
    quad(kFloor, {-x, 0, z}, {w_, 0, 0}, {0, 0, -d_});
    quad(kCeiling, {-x, h_, -z}, {x, top, -z}, {x, top, z}, {-x, h_, z});
    side({-x, 0, z}, {0, 0, -1}, d_, h_);  // at -x
    if (slope_ > 0.0) {
      quad(kWall, {-x, 0, -z}, {x, 0, -z}, {x, top, -z}, {-x, h_, -z});
      quad(kWall, {x, 0, z}, {-x, 0, z}, {-x, h_, z}, {x, top, z});
    } else {
      side({-x, 0, -z}, {1, 0, 0}, w_, h_);                 // at -z
      if (!openSide_) side({x, 0, z}, {-1, 0, 0}, w_, h_);  // at +z
    }
    if (!leg_) {
      side({x, 0, -z}, {0, 0, 1}, d_, top);  // at +x
      return;
    }
    const double length = between(0.4, 1.0) * w_, begin = between(-0.3, 0.2) * d_, width = z - begin;
    wall({x, 0, -z}, {0, 0, 1}, begin + z, h_, {});
    wall({x, 0, begin}, {1, 0, 0}, length, h_, {});
    wall({x + length, 0, begin}, {0, 0, 1}, width, h_, {});
    wall({x + length, 0, z}, {-1, 0, 0}, length, h_, {});
    quad(kFloor, {x, 0, z}, {length, 0, 0}, {0, 0, -width});
    quad(kCeiling, {x, h_, begin}, {length, 0, 0}, {0, 0, width});
  }

  void block(Look look, const Piece& piece) {
    const double c = std::cos(piece.angle), s = std::sin(piece.angle);
    const glm::dvec3 axis[3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 n = axis[i] * piece.half[i], u = axis[(i + 1) % 3] * piece.half[(i + 1) % 3],
                       v = axis[(i + 2) % 3] * piece.half[(i + 2) % 3];
      quad(look, piece.middle + n - u - v, 2.0 * u, 2.0 * v);
      quad(look, piece.middle - n - u - v, 2.0 * v, 2.0 * u);
    }
    pieces_.push_back(piece);
  }

  void furnish() {
    const double kind = between(0.0, 1.0);
    const Look look = chance(0.15) ? kMetal : chance(0.5) ? kWood : kCloth;
    const double turn = chance(0.7) ? 0.0 : between(0.0, 3.0);
    if (kind < 0.35) {  // against a wall, tall
      const glm::dvec3 half(between(0.3, 0.8), between(0.5, 1.1), between(0.15, 0.3));
      const bool alongX = chance(0.5);
      const double sign = chance(0.5) ? 1.0 : -1.0, along = between(-0.4, 0.4);
      if (alongX) {
        block(look, {{along * w_, half.y, sign * (0.5 * d_ - half.z - 0.01)}, half, 0.0});
      } else {
        block(look, {{sign * (0.5 * w_ - half.z - 0.01), half.y, along * d_}, {half.z, half.y, half.x}, 0.0});
      }
    } else if (kind < 0.75) {  // low, anywhere
      const glm::dvec3 half(between(0.25, 0.9), between(0.15, 0.45), between(0.25, 0.6));
      block(look, {{between(-0.35, 0.35) * w_, half.y + 0.001, between(-0.35, 0.35) * d_}, half, turn});
    } else if (kind < 0.9) {  // a table top
      const glm::dvec3 half(between(0.4, 0.9), 0.02, between(0.3, 0.5));
      block(look, {{between(-0.35, 0.35) * w_, 0.74, between(-0.35, 0.35) * d_}, half, turn});
    } else {  // a lamp
      const glm::dvec3 half(between(0.1, 0.3));
      block(look, {{between(-0.3, 0.3) * w_, h_ - half.y - between(0.1, 0.7), between(-0.3, 0.3) * d_}, half, 0.0});
    }
  }

  glm::dvec3 freePoint(double low, double high, double spread) {
    glm::dvec3 point(0.0);
    for (int tries = 0; tries < 50; ++tries) {
      point = {between(-0.5, 0.5) * spread * w_, between(low, std::min(high, h_ - 0.2)),
               between(-0.5, 0.5) * spread * d_};
      if (std::none_of(pieces_.begin(), pieces_.end(), [&](const Piece& p) { return p.holds(point, 0.12); })) break;
    }
    return point;
  }

  std::mt19937 random_;
  std::uint32_t feature_;
  Model model_;
  double w_ = 0.0, d_ = 0.0, h_ = 0.0, slope_ = 0.0;
  bool openSide_ = false, leg_ = false, windows_ = false;
  std::vector<Piece> pieces_;
};

}  // namespace

RandomRoom randomRoom(std::uint32_t seed) {
  return Maker(seed).make();
}

}  // namespace boxprobe::test
