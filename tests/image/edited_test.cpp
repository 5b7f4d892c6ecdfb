// An edited scene shows what a fresh start of it shows: every field of the scene file, one after the other, in the room
// of odd_room.h. And where another capture would be made, its key says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/core/scene/scene_fields.h"
#include "tests/support/odd_room.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

constexpr int kWidth = 40, kHeight = 24;

/// A renderer that shows the room, edited as it goes.
class Shown {
 public:
  explicit Shown(const OddRoom& room) : models_{room.model}, picture_(room.scene, kWidth, kHeight) {
    startAgain(room.scene);
  }
  /// A new renderer; the window, and the programs that it has compiled, stay.
  void startAgain(const Scene& scene) {
    picture_.renderer.reset();
    picture_.renderer = std::make_unique<SceneRenderer>(picture_.window);
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
};

/// In display colours of eight bits, which is what people see of it.
int farthest(const ImageRgbaF& a, const ImageRgbaF& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const auto display = [](float x) { return std::pow(std::clamp(static_cast<double>(x), 0.0, 1.0), 1.0 / 2.2); };
    most = std::max(most, std::abs(display(a.pixels[i]) - display(b.pixels[i])));
  }
  return static_cast<int>(std::lround(255.0 * most));
}

/// Largest difference of a component of level 0, over 1 and what the texel holds; infinite for other sizes.
double farthestTexel(const BakedMaps& a, const BakedMaps& b) {
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

double within(double value, const FieldInfo& field) {
  const FieldRange range = field.usual.value_or(field.range);
  return std::clamp(value, std::max(range.lowest, field.range.lowest), std::min(range.highest, field.range.highest));
}

double otherNumber(double now, const FieldInfo& field) {
  const double up = within(1.31 * now + 0.19, field);
  return up != now ? up : within(0.73 * now - 0.11, field);
}

/// Another value that the row allows; nothing where the row has none to offer without knowing what it means.
std::optional<FieldValue> otherValue(const FieldInfo& field, const FieldValue& now, const FieldValue& whereNone) {
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
  if (const auto* vector = std::get_if<glm::dvec3>(&from)) return FieldValue(*vector + glm::dvec3(0.23, -0.17, 0.31));
  if (const auto* box = std::get_if<Box>(&from)) {
    return FieldValue(Box{box->min + glm::dvec3(0.27, 0.13, 0.19), box->max - glm::dvec3(0.33, 0.41, 0.22)});
  }
  if (const auto* blend = std::get_if<BlendDistance>(&from)) {
    return FieldValue(
        BlendDistance{blend->min + glm::dvec3(0.17, 0.05, 0.31), blend->max + glm::dvec3(0.4, 0.23, 0.09)});
  }
  if (std::get_if<Bevel>(&from) != nullptr) return FieldValue(Bevel{0.28, 0.41});
  if (std::get_if<BoxOcclusion>(&from) != nullptr) return FieldValue(BoxOcclusion{0.37, 1.4, 0.68});
  if (std::get_if<Clear>(&from) != nullptr) return FieldValue(Clear(glm::vec3(0.21f, 0.43f, 0.11f)));
  if (const auto* names = std::get_if<std::vector<std::string>>(&from)) {
    return FieldValue(names->empty() ? std::vector<std::string>{"pillar"} : std::vector<std::string>{});
  }
  return std::nullopt;
}

struct Step {
  std::string field;
  Scene scene;
};

/// `scene` with each field of a part changed, one at a time; `part` finds the part in a scene.
template <typename Part>
void addSteps(std::vector<Step>& steps, const std::string& place, const Scene& scene,
              const std::vector<FieldRow<Part>>& rows, const std::function<Part&(Scene&)>& part,
              const std::function<FieldValue(const FieldRow<Part>&)>& whereNone) {
  for (const FieldRow<Part>& row : rows) {
    if (row.get == nullptr) continue;
    Step step{place + "." + std::string(row.key), scene};
    Part& edited = part(step.scene);
    const auto other = otherValue(row, row.get(edited), whereNone(row));
    if (!other) continue;
    row.set(edited, *other);
    try {
      validate(step.scene);
    } catch (const InputError&) {
      continue;  // needs another field with it: pictures, modes
    }
    steps.push_back(std::move(step));
  }
}

FieldValue valueOfKind(FieldKind kind) {
  switch (kind) {
    case FieldKind::Box:
      return Box{{-2.1, 0.3, -1.5}, {2.8, 2.7, 2.3}};
    case FieldKind::Bevel:
      return Bevel{};
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

/// Each row once, at one of the parts that have it; another part for the next row.
template <typename Part>
std::vector<FieldRow<Part>> everyNth(const std::vector<FieldRow<Part>>& rows, std::size_t n, std::size_t first) {
  std::vector<FieldRow<Part>> some;
  for (std::size_t i = first; i < rows.size(); i += n) some.push_back(rows[i]);
  return some;
}

/// Everything but the probes. `scene` has a sky.
std::vector<Step> sceneSteps(const Scene& scene) {
  std::vector<Step> steps;
  const auto none = [](const auto&) { return FieldValue(); };
  addSteps<Scene>(
      steps, "scene", scene, sceneFields(), [](Scene& s) -> Scene& { return s; },
      [](const auto& row) { return valueOfKind(row.kind); });
  addSteps<ModelFile>(
      steps, "model", scene, modelFields(), [](Scene& s) -> ModelFile& { return s.models[0]; }, none);
  addSteps<SkyGradient>(
      steps, "sky", scene, skyGradientFields(), [](Scene& s) -> SkyGradient& { return std::get<SkyGradient>(s.sky); },
      none);
  addSteps<Camera>(
      steps, "camera", scene, cameraFields(), [](Scene& s) -> Camera& { return s.cameras[0]; }, none);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    std::vector<FieldRow<Light>> rows;
    for (const FieldRow<Light>& row : lightFields()) {
      // The last light that has it: the spot has all but the sun's angle.
      const bool later = i + 1 < scene.lights.size() && hasField(scene.lights.back().type, row);
      if (hasField(scene.lights[i].type, row) && (!later || row.key == "intensity")) rows.push_back(row);
    }
    addSteps<Light>(
        steps, "lights[" + std::to_string(i) + "]", scene, rows, [i](Scene& s) -> Light& { return s.lights[i]; }, none);
  }
  const char* materials[] = {"floor", "paint", "glass"};
  for (std::size_t i = 0; i < 3; ++i) {
    addSteps<MaterialOverride>(
        steps, materials[i], scene, i == 2 ? materialFields() : everyNth(materialFields(), 2, i),
        [&](Scene& s) -> MaterialOverride& { return s.materials[materials[i]]; },
        [](const auto& row) {
          return row.singlePrecision && row.kind == FieldKind::Number ? FieldValue(0.35f) : valueOfKind(row.kind);
        });
  }
  addSteps<ObjectOverride>(
      steps, "pillar", scene, objectFields(), [](Scene& s) -> ObjectOverride& { return s.objects["pillar"]; }, none);
  return steps;
}

/// Of a scene without a sky: where probes leave weight to it is part of a first capture, and no drag makes that again.
std::vector<Step> probeSteps(const Scene& scene) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    addSteps<Probe>(
        steps, "probe " + scene.probes[i].name, scene, everyNth(probeFields(), 3, i),
        [i](Scene& s) -> Probe& { return s.probes[i]; }, [](const auto& row) { return valueOfKind(row.kind); });
  }
  for (const char* technique : {"infinite", "sphere", "impostor", "box+footprint4", "hdrp"}) {
    Step step{std::string("technique ") + technique, scene};
    step.scene.probes[2].technique = technique;
    steps.push_back(std::move(step));
  }
  for (const char* usage : {"probeMode", "weights"}) {
    Step step{std::string("floor.") + usage, scene};
    const FieldRow<ObjectOverride>& row = objectField(usage);
    row.set(step.scene.objects["floor"], *otherValue(row, row.get({}), {}));
    steps.push_back(std::move(step));
  }
  Step two{"bounces of all", scene};
  for (Probe& probe : two.scene.probes) probe.bounces = 2;
  steps.push_back(std::move(two));
  return steps;
}

/// From one of two overrides to the other: their keys must not be the same.
void addPairs(std::vector<std::pair<Step, Step>>& pairs, const Scene& scene) {
  using Set = std::function<void(MaterialOverride&)>;
  const std::vector<std::pair<std::string, Set>> overrides = {
      {"thickness", [](MaterialOverride& m) { m.thickness = 0.5f; }},
      {"attenuationDistance", [](MaterialOverride& m) { m.attenuationDistance = 0.5f; }},
      {"roughness", [](MaterialOverride& m) { m.roughness = 0.5f; }},
      {"metallic", [](MaterialOverride& m) { m.metallic = 0.5f; }},
      {"coat", [](MaterialOverride& m) { m.coat = 0.5f; }},
      {"transmission", [](MaterialOverride& m) { m.transmission = 0.5f; }},
      {"baseColor", [](MaterialOverride& m) { m.baseColor = glm::vec3(0.5f); }},
      {"emissive", [](MaterialOverride& m) { m.emissive = glm::vec3(0.5f); }},
      {"attenuationColor", [](MaterialOverride& m) { m.attenuationColor = glm::vec3(0.5f); }},
  };
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const auto& [firstName, first] = overrides[i];
    const auto& [secondName, second] = overrides[(i + 1) % overrides.size()];
    Step from{firstName, scene}, to{secondName, scene};
    first(from.scene.materials["glass"]);
    second(to.scene.materials["glass"]);
    pairs.emplace_back(std::move(from), std::move(to));
  }
}

/// Whatever the edit, the picture is a fresh start's; and where the capture is another one, its key is, too.
struct Found {
  int visible = 0, recaptured = 0;
};
Found expectFresh(const OddRoom& room, const std::vector<Step>& steps) {
  Found found;
  Shown edited(room), fresh(room);
  const ImageRgbaF before = edited.picture();
  const auto mapsBefore = edited.maps("a");
  const std::string keyBefore = edited.key("a");
  EXPECT_FALSE(keyBefore.empty());
  for (const Step& step : steps) {
    SCOPED_TRACE(step.field);
    edited.edit(step.scene);
    const ImageRgbaF shown = edited.picture();
    fresh.startAgain(step.scene);
    const ImageRgbaF expected = fresh.picture();
    EXPECT_LE(farthest(shown, expected), 1) << "differs from a fresh start";
    found.visible += farthest(before, expected) > 1 ? 1 : 0;
    // Equal keys stand for equal texels: what a file that was baked before is taken for.
    if (!fresh.key("a").empty()) {
      EXPECT_EQ(edited.key("a"), fresh.key("a"));
      const auto maps = fresh.maps("a");
      if (maps && mapsBefore && farthestTexel(*maps, *mapsBefore) > 1e-3) {
        ++found.recaptured;
        EXPECT_NE(fresh.key("a"), keyBefore) << "another capture under the same key";
      }
    }
    edited.edit(room.scene);
  }
  EXPECT_LE(farthest(edited.picture(), before), 1) << "all taken back";
  std::printf("%zu fields, %d change the picture, %d the capture of probe a\n", steps.size(), found.visible,
              found.recaptured);
  return found;
}

TEST(Edited, EveryFieldOfAProbeShowsWhatAFreshStartShows) {
  OddRoom room = oddRoom();
  room.scene.sky = SkyColor{};
  const Found found = expectFresh(room, probeSteps(room.scene));
  EXPECT_GE(found.visible, 20);
  EXPECT_GE(found.recaptured, 4);
}

TEST(Edited, EveryOtherFieldShowsWhatAFreshStartShows) {
  const OddRoom room = oddRoom();
  const Found found = expectFresh(room, sceneSteps(room.scene));
  EXPECT_GE(found.visible, 40);
  EXPECT_GE(found.recaptured, 25);
}

// Filtered with other samples: each level of the chain, whichever way the probe comes to its maps.
TEST(Edited, FilterSamplesCountInEveryMode) {
  for (const ProbeMode mode : {ProbeMode::Baked, ProbeMode::Realtime, ProbeMode::Custom}) {
    SCOPED_TRACE(static_cast<int>(mode));
    OddRoom room = oddRoom();
    room.scene.probes[0].mode = mode;
    if (mode == ProbeMode::Custom) room.scene.probes[0].image = BOXPROBE_DATA_DIR "/environments/studio.hdr";
    Shown edited(room), fresh(room);
    Scene more = room.scene;
    more.probes[0].filterSamples = 96;
    edited.edit(more);
    fresh.startAgain(more);
    const auto maps = edited.maps("a"), expected = fresh.maps("a");
    ASSERT_TRUE(maps && expected);
    const CubeMap& a = maps->radiance;
    const CubeMap& b = expected->radiance;
    ASSERT_EQ(a.levels(), b.levels());
    double most = 0.0;
    for (int level = 1; level < a.levels(); ++level) {
      const int size = a.levelSize(level);
      for (int texel = 0; texel < 6 * size * size; ++texel) {
        const int face = texel / (size * size), row = texel / size % size, column = texel % size;
        const glm::dvec4 d(a.texel(level, face, column, row) - b.texel(level, face, column, row));
        most = std::max({most, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
      }
    }
    EXPECT_LE(most, 1e-6);
  }
}

TEST(Edited, OneOverrideIsNotTakenForAnother) {
  const OddRoom room = oddRoom();
  std::vector<std::pair<Step, Step>> pairs;
  addPairs(pairs, room.scene);
  Shown edited(room), fresh(room);
  for (const auto& [from, to] : pairs) {
    SCOPED_TRACE(from.field + " .5, then " + to.field + " .5");
    edited.edit(from.scene);
    const std::string key = edited.key("a");
    edited.edit(to.scene);
    const ImageRgbaF shown = edited.picture();
    fresh.startAgain(to.scene);
    EXPECT_NE(edited.key("a"), key);
    const auto maps = edited.maps("a"), expected = fresh.maps("a");
    ASSERT_TRUE(maps && expected);
    EXPECT_LE(farthestTexel(*maps, *expected), 1e-6) << "the capture is another one than a fresh start's";
    EXPECT_LE(farthest(shown, fresh.picture()), 1);
  }
}

}  // namespace
}  // namespace boxprobe::test
