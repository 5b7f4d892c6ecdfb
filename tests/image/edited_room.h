// The odd room shown by a renderer that is edited as it goes, and by one that is started again; and another legal value
// for any field of the scene file.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/scene_fields.h"
#include "filters/fit/rays/triangle_sight.h"
#include "tests/support/odd_room.h"
#include "tests/support/scene_picture.h"
#include "tests/support/shown_light.h"

namespace boxprobe::test {

inline constexpr int kEditedWidth = 40, kEditedHeight = 24;

/// A renderer that shows the room, edited as it goes.
class Shown {
 public:
  /// `traced`: with shadows of lamps, lattices, occlusion of the sky and the ground's shadow.
  explicit Shown(const OddRoom& room, bool traced = false)
      : models_{room.model}, picture_(room.scene, kEditedWidth, kEditedHeight), traced_(traced) {
    startAgain(room.scene);
  }
  /// A new renderer; the window, and the programs that it has compiled, stay.
  void startAgain(const Scene& scene) {
    picture_.renderer.reset();
    picture_.renderer = std::make_unique<SceneRenderer>(picture_.window);
    if (traced_) picture_.renderer->setSightLines(traceSightLines);
    picture_.scene = scene;
    camera_ = scene.cameras.front();
    picture_.renderer->setModels(models_);
    sync(Changes::all());
  }
  void edit(const Scene& scene) {
    const Changes changes = difference(picture_.scene, scene);
    picture_.scene = scene;
    camera_ = scene.cameras.front();
    if (changes.models) picture_.renderer->setModels(models_);
    sync(changes);
  }
  ImageRgbaF picture() { return picture_.linear(1); }
  /// As people see it: exposed, with a background.
  ImageRgba8 display() { return picture_.display(); }
  std::string key(const std::string& probe) const {
    const auto keys = picture_.renderer->bakeKeys(probe);
    return keys.empty() ? std::string() : keys.back();
  }
  std::optional<BakedMaps> maps(const std::string& probe) { return picture_.renderer->readMaps(probe); }
  const Counters& counters() const { return picture_.renderer->counters(); }

 private:
  void sync(const Changes& changes) {
    picture_.renderer->sync(picture_.scene, changes);
    picture_.renderer->applyCamera(camera_);
    picture_.renderer->finishWork();
    EXPECT_EQ(picture_.renderer->error(), "");
  }
  std::vector<std::shared_ptr<const Model>> models_;
  ScenePicture picture_;
  Camera camera_;
  bool traced_;
};

/// In display colours of eight bits, which is what people see of it.
inline int farthest(const ImageRgbaF& a, const ImageRgbaF& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    most = std::max(most, std::abs(shownLight(a.pixels[i]) - shownLight(b.pixels[i])));
  }
  return static_cast<int>(std::lround(255.0 * most));
}

inline int farthest(const ImageRgba8& a, const ImageRgba8& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
  return most;
}

/// Largest difference of a component of level 0, over 1 and what the texel holds; infinite for other sizes.
inline double farthestTexel(const BakedMaps& a, const BakedMaps& b) {
  const int size = a.radiance.faceSize();
  if (size != b.radiance.faceSize()) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < size * size; ++i) {
      const glm::dvec4 x(a.radiance.texel(0, face, i % size, i / size)),
          y(b.radiance.texel(0, face, i % size, i / size));
      for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(x[c] - y[c]) / (1.0 + std::abs(x[c])));
    }
  }
  return most;
}

inline double within(double value, const FieldInfo& field) {
  const FieldRange range = field.usual.value_or(field.range);
  return std::clamp(value, std::max(range.lowest, field.range.lowest), std::min(range.highest, field.range.highest));
}

inline double otherNumber(double now, const FieldInfo& field) {
  const double up = within(1.31 * now + 0.19, field);
  return up != now ? up : within(0.73 * now - 0.11, field);
}

/// Another value that the row allows; nothing where the row has none to offer without knowing what it means.
inline std::optional<FieldValue> otherValue(const FieldInfo& field, const FieldValue& now,
                                            const FieldValue& whereNone) {
  const FieldValue from = std::holds_alternative<std::monostate>(now) ? whereNone : now;
  if (const auto* flag = std::get_if<bool>(&from)) return FieldValue(!*flag);
  if (const auto* number = std::get_if<double>(&from)) return FieldValue(otherNumber(*number, field));
  if (const auto* single = std::get_if<float>(&from)) {
    return FieldValue(static_cast<float>(otherNumber(static_cast<double>(*single), field)));
  }
  if (const auto* whole = std::get_if<int>(&from)) {
    if (!field.choices.empty()) return FieldValue((*whole + 1) % static_cast<int>(field.choices.size()));
    for (const int value : field.values) {
      if (value > *whole) return FieldValue(value);
    }
    return FieldValue(static_cast<int>(within(*whole + 8, field)));
  }
  if (const auto* color = std::get_if<glm::vec3>(&from)) {
    return FieldValue(glm::vec3(0.37f, 0.81f, 0.55f) * (*color + 0.07f));
  }
  if (const auto* vector = std::get_if<glm::dvec3>(&from)) {
    const bool degrees = field.key.find("Degrees") != std::string_view::npos;
    return FieldValue(*vector + (degrees ? 40.0 : 1.0) * glm::dvec3(0.23, -0.17, 0.31));
  }
  if (const auto* box = std::get_if<Box>(&from)) {
    return FieldValue(Box{box->min + glm::dvec3(0.27, 0.13, 0.19), box->max - glm::dvec3(0.33, 0.41, 0.22)});
  }
  if (const auto* blend = std::get_if<BlendDistance>(&from)) {
    return FieldValue(
        BlendDistance{blend->min + glm::dvec3(0.17, 0.05, 0.31), blend->max + glm::dvec3(0.4, 0.23, 0.09)});
  }
  if (std::get_if<Bevel>(&from) != nullptr) return FieldValue(Bevel{0.28, 0.41});
  if (std::get_if<ProbeLattice>(&from) != nullptr) return FieldValue(ProbeLattice{true, 0.63});
  if (std::get_if<BoxOcclusion>(&from) != nullptr) return FieldValue(BoxOcclusion{0.37, 1.4, 0.68});
  if (std::get_if<Clear>(&from) != nullptr) return FieldValue(Clear(glm::vec3(0.21f, 0.43f, 0.11f)));
  if (const auto* names = std::get_if<std::vector<std::string>>(&from)) {
    return FieldValue(names->empty() ? std::vector<std::string>{"pillar"} : std::vector<std::string>{});
  }
  return std::nullopt;
}

inline FieldValue valueOfKind(FieldKind kind) {
  switch (kind) {
    case FieldKind::Box:
      return Box{{-2.1, 0.3, -1.5}, {2.8, 2.7, 2.3}};
    case FieldKind::Bevel:
      return Bevel{};
    case FieldKind::LatticeOrNone:
      return ProbeLattice{};
    case FieldKind::Occlusion:
      return BoxOcclusion{};
    case FieldKind::Color:
      return glm::vec3(0.5f, 0.4f, 0.3f);
    case FieldKind::Boolean:
      return false;
    case FieldKind::Choice:
      return 0;
    case FieldKind::Number:
      return 0.35;
    default:
      return {};
  }
}

}  // namespace boxprobe::test
