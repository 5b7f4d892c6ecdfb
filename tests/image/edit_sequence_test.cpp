// Edits on top of each other, drawn by a fixed seed from every row of the scene's tables, with undo among them: after
// each the picture, the maps and the keys are those of a renderer that has seen nothing before.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <set>

#include "filters/core/base/errors.h"
#include "tests/image/edited_room.h"

namespace boxprobe::test {
namespace {

struct Edit {
  std::string field;
  std::function<bool(Scene&)> make;  ///< false: the row has no other value to offer here
};

/// Every row of a table for the part that `part` finds.
template <typename Part>
void addEdits(std::vector<Edit>& edits, const std::string& place, const std::vector<FieldRow<Part>>& rows,
              const std::function<Part&(Scene&)>& part, const std::set<std::string>& without = {}) {
  for (const FieldRow<Part>& row : rows) {
    if (row.get == nullptr || without.count(std::string(row.key)) != 0) continue;
    const FieldRow<Part>* held = &row;
    edits.push_back({place + "." + std::string(row.key), [held, part](Scene& scene) {
                       Part& edited = part(scene);
                       const bool single = held->singlePrecision && held->kind == FieldKind::Number;
                       const FieldValue whereNone = single ? FieldValue(0.35f) : valueOfKind(held->kind);
                       const auto other = otherValue(*held, held->get(edited), whereNone);
                       if (other) held->set(edited, *other);
                       return other.has_value();
                     }});
  }
}

/// A first capture has what boxes leave a share of: the sky's light, and that of lamps that ask for coverage; a further
/// bounce shows other probes. All of that stays as baked when a box is dragged (capture_key.h), so that boxes are
/// edited without any of it.
enum class Of { Probes, EverythingElse };

std::vector<Edit> editsOf(Of of, const Scene& scene) {
  std::vector<Edit> edits;
  if (of == Of::Probes) {
    for (std::size_t i = 0; i < scene.probes.size(); ++i) {
      const auto probe = [i](Scene& s) -> Probe& { return s.probes[i]; };
      addEdits<Probe>(edits, "probe " + scene.probes[i].name, probeFields(), probe, {"bounces"});
    }
    addEdits<ObjectOverride>(edits, "object floor", objectFields(),
                             [](Scene& s) -> ObjectOverride& { return s.objects["floor"]; });
    return edits;
  }
  addEdits<Scene>(edits, "scene", sceneFields(), [](Scene& s) -> Scene& { return s; });
  addEdits<ModelFile>(edits, "model", modelFields(), [](Scene& s) -> ModelFile& { return s.models[0]; });
  addEdits<Camera>(edits, "camera", cameraFields(), [](Scene& s) -> Camera& { return s.cameras[0]; });
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto light = [i](Scene& s) -> Light& { return s.lights[i]; };
    addEdits<Light>(edits, "lights[" + std::to_string(i) + "]", lightFields(), light);
  }
  for (const char* name : {"floor", "paint", "glass", "toy"}) {
    const auto material = [name](Scene& s) -> MaterialOverride& { return s.materials[name]; };
    addEdits<MaterialOverride>(edits, name, materialFields(), material);
  }
  for (const char* name : {"pillar", "block", "mover", "floor"}) {
    const auto object = [name](Scene& s) -> ObjectOverride& { return s.objects[name]; };
    addEdits<ObjectOverride>(edits, std::string("object ") + name, objectFields(), object);
  }
  addEdits<SkyGradient>(edits, "sky", skyGradientFields(),
                        [](Scene& s) -> SkyGradient& { return std::get<SkyGradient>(s.sky); });
  return edits;
}

bool isValid(const Scene& scene) {
  try {
    validate(scene);
    return true;
  } catch (const InputError&) {
    return false;  // a value that needs another field with it
  }
}

/// Every level, not the first alone: what is filtered counts, too.
double farthestOfLevels(const BakedMaps& a, const BakedMaps& b) {
  const CubeMap &x = a.radiance, &y = b.radiance;
  if (x.faceSize() != y.faceSize() || x.levels() != y.levels()) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (int level = 0; level < x.levels(); ++level) {
    const int size = x.levelSize(level);
    for (int i = 0; i < 6 * size * size; ++i) {
      const int face = i / (size * size), row = i / size % size, column = i % size;
      const glm::dvec4 p(x.texel(level, face, column, row)), q(y.texel(level, face, column, row));
      for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(p[c] - q[c]) / (1.0 + std::abs(p[c])));
    }
  }
  return most;
}

struct Made {
  std::set<std::string> fields;
  int visible = 0;
  std::map<std::string, BakedMaps> mapsOfKey;
};

/// Two edits between one comparison and the next.
void expectAsFresh(const OddRoom& room, const std::vector<Edit>& edits, std::uint32_t seed, Made& made) {
  constexpr int kComparisons = 24;
  constexpr std::size_t kUndoneOfTen = 2;
  Shown edited(room), fresh(room);
  std::vector<Scene> history{room.scene};
  // By hand, not by a distribution of the library, whose numbers differ from one to the next.
  std::mt19937 random(seed);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto next = [&](Scene& scene) {
    if (history.size() > 3 && below(10) < kUndoneOfTen) {
      scene = history[below(history.size() - 1)];
      return std::string("undo");
    }
    for (;;) {
      const Edit& edit = edits[below(edits.size())];
      scene = history.back();
      if (!edit.make(scene) || scene == history.back() || !isValid(scene)) continue;
      made.fields.insert(edit.field);
      return edit.field;
    }
  };
  ImageRgbaF before = edited.picture();
  for (int i = 0; i < kComparisons; ++i) {
    std::string what;
    for (const char* separator : {", ", ""}) {
      Scene scene;
      what += next(scene) + separator;
      edited.edit(scene);
      history.push_back(std::move(scene));
    }
    const Scene& scene = history.back();
    SCOPED_TRACE(std::to_string(2 * i) + ": " + what);
    fresh.startAgain(scene);
    const ImageRgbaF shown = edited.picture();
    EXPECT_LE(farthest(shown, fresh.picture()), 1) << "differs from a fresh start";
    made.visible += farthest(before, shown) > 1 ? 1 : 0;
    before = shown;
    for (const Probe& probe : scene.probes) {
      const std::string key = fresh.key(probe.name);
      EXPECT_EQ(edited.key(probe.name), key) << probe.name;
      const auto maps = edited.maps(probe.name), expected = fresh.maps(probe.name);
      ASSERT_EQ(maps.has_value(), expected.has_value()) << probe.name;
      if (!maps) continue;
      EXPECT_LE(farthestOfLevels(*maps, *expected), 1e-3) << probe.name << " holds another capture";
      if (key.empty()) continue;
      const auto [at, added] = made.mapsOfKey.emplace(key, *expected);
      EXPECT_LE(added ? 0.0 : farthestOfLevels(at->second, *expected), 1e-3) << probe.name << ": one key, two captures";
    }
    if (testing::Test::HasFailure()) return;  // all that follows stands on it
  }
  std::printf("%d edits, %zu fields; %d of %d change the picture; %zu keys\n", 2 * kComparisons, made.fields.size(),
              made.visible, kComparisons, made.mapsOfKey.size());
}

TEST(EditSequence, ProbesKeepNothingOfTheEditsBefore) {
  OddRoom room = oddRoom();
  room.scene.sky = SkyColor{};
  Made made;
  expectAsFresh(room, editsOf(Of::Probes, room.scene), 20261126, made);
  EXPECT_GE(made.fields.size(), 25u);
  EXPECT_GE(made.visible, 12);
  EXPECT_GE(made.mapsOfKey.size(), 15u);
}

TEST(EditSequence, AllElseKeepsNothingOfTheEditsBefore) {
  OddRoom room = oddRoom();
  room.scene.lights[0].shadows = LightShadows::Coverage;
  room.scene.lights[2].shadows = LightShadows::CoverageAndMap;
  Made made;
  expectAsFresh(room, editsOf(Of::EverythingElse, room.scene), 20261127, made);
  EXPECT_GE(made.fields.size(), 25u);
  EXPECT_GE(made.visible, 12);
  EXPECT_GE(made.mapsOfKey.size(), 25u);
}

}  // namespace
}  // namespace boxprobe::test
