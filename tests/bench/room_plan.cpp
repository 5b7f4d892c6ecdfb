// See room_plan.h.
#include "tests/bench/room_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe::bench {

namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr int kView = 520, kGap = 20, kSide = 2 * kView + 3 * kGap;
constexpr Color kWall{20, 20, 24}, kLow{150, 150, 160}, kOrigin{200, 30, 120}, kCamera{40, 90, 200};

/// One of the three drawings: the picture's right and down as axes of the world.
struct View {
  int left, top;            ///< pixels
  int across, down, depth;  ///< axes
  double sign;              ///< of `down`
};
constexpr View kViews[] = {
    {kGap, kGap, 0, 2, 1, 1.0}, {2 * kGap + kView, kGap, 0, 1, 2, -1.0}, {kGap, 2 * kGap + kView, 2, 1, 0, -1.0}};

class Sheet {
 public:
  Sheet(const glm::dvec3& middle, double reach) : middle_(middle), scale_(0.5 * kView / reach) {
    image_.width = image_.height = kSide;
    image_.pixels.assign(static_cast<std::size_t>(4 * kSide * kSide), 255);
  }

  glm::dvec2 at(const View& view, const glm::dvec3& world) const {
    const glm::dvec3 p = (world - middle_) * scale_;
    return {view.left + 0.5 * kView + p[view.across], view.top + 0.5 * kView + view.sign * p[view.down]};
  }

  void line(const View& view, const glm::dvec3& a, const glm::dvec3& b, const Color& color, double thick) {
    const glm::dvec2 from = at(view, a), to = at(view, b);
    const int steps = std::clamp(static_cast<int>(2.0 * glm::length(to - from)), 1, 20000);
    for (int i = 0; i <= steps; ++i) dot(view, glm::mix(from, to, static_cast<double>(i) / steps), color, thick);
  }

  void dot(const View& view, const glm::dvec2& place, const Color& color, double radius) {
    const int reach = static_cast<int>(std::ceil(radius));
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const int px = static_cast<int>(std::lround(place.x)) + x, py = static_cast<int>(std::lround(place.y)) + y;
        if (x * x + y * y > radius * radius + 0.3 || px < view.left || py < view.top || px >= view.left + kView ||
            py >= view.top + kView) {
          continue;
        }
        std::copy(color.begin(), color.end(),
                  image_.pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(py) * kSide + px));
      }
    }
  }

  ImageRgba8 take() { return std::move(image_); }

 private:
  glm::dvec3 middle_;
  double scale_;
  ImageRgba8 image_;
};

/// Where triangles cross the plane `axis` = `value`.
template <typename Draw>
void cut(const Model& model, int axis, double value, const Draw& draw) {
  for (const Instance& instance : model.instances) {
    const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::array<glm::dvec3, 3> corner;
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = glm::dvec3(instance.worldFromModel * glm::dvec4(mesh.positions[mesh.indices[i + k]], 1.0));
      }
      std::vector<glm::dvec3> crossed;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &a = corner[k], &b = corner[(k + 1) % 3];
        if ((a[axis] < value) == (b[axis] < value)) continue;
        crossed.push_back(glm::mix(a, b, (value - a[axis]) / (b[axis] - a[axis])));
      }
      if (crossed.size() == 2) draw(crossed[0], crossed[1]);
    }
  }
}

}  // namespace

ImageRgba8 roomPlan(const test::RandomRoom& room, const std::vector<DrawnBox>& boxes) {
  const Probe& probe = room.scene.probes.front();
  // About the first box: rooms stand anywhere.
  const Box& about = boxes.front().probe.box;
  const glm::dvec3 half = 0.5 * about.size();
  Sheet sheet(about.center(), 1.5 * std::max({half.x, half.y, half.z}));
  constexpr double kFurniture = 0.4;
  cut(*room.model, 1, kFurniture, [&](const auto& a, const auto& b) { sheet.line(kViews[0], a, b, kLow, 1.0); });
  for (const View& view : kViews) {
    cut(*room.model, view.depth, probe.origin[view.depth],
        [&](const auto& a, const auto& b) { sheet.line(view, a, b, kWall, 1.0); });
    for (const Camera& camera : room.scene.cameras) {
      const glm::dvec3 ahead = glm::normalize(camera.target - camera.position);
      sheet.line(view, camera.position, camera.position + 0.4 * ahead, kCamera, 1.0);
      sheet.dot(view, sheet.at(view, camera.position), kCamera, 4.0);
    }
    for (const DrawnBox& box : boxes) {
      const auto corners =
          boxCornersWorld(box.probe.box, rotationMatrix(box.probe.rotationDegrees), box.probe.box.center());
      for (const auto& edge : boxEdges()) {
        sheet.line(view, corners[static_cast<std::size_t>(edge[0])], corners[static_cast<std::size_t>(edge[1])],
                   box.color, 1.0);
      }
    }
    sheet.dot(view, sheet.at(view, probe.origin), kOrigin, 5.0);
  }
  return sheet.take();
}

}  // namespace boxprobe::bench
