// The tables of the scene's fields: every row is sound, is read, written, compared, validated and told as a change; and
// the document that holds the reference is up to date.
#include "filters/core/scene/scene_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "filters/core/base/file_limits.h"
#include "filters/io/scene/scene_file.h"
#include "filters/io/scene/scene_reference.h"
#include "filters/math/technique/parameter_table.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;

/// A sound value other than `standard`, or nothing for kinds that need more than one field to be sound.
FieldValue another(const FieldInfo& field, const FieldValue& standard) {
  const auto inRange = [&](double old) {
    const FieldRange r = field.range;
    if (!field.values.empty()) return double(field.values[old == field.values[0] ? 1 : 0]);
    const double low = std::max(r.lowest, -8.0), high = std::min(r.highest, 64.0);
    const double middle = std::floor(0.5 * (low + high) * 4.0) / 4.0;
    return middle == old ? middle + 0.25 : middle;
  };
  switch (field.kind) {
    case FieldKind::Number:
      if (field.singlePrecision) return static_cast<float>(inRange(-1.0));
      return inRange(std::holds_alternative<double>(standard) ? std::get<double>(standard) : -1.0);
    case FieldKind::Integer:
      return static_cast<int>(inRange(std::get<int>(standard)));
    case FieldKind::Boolean:
      return !(std::holds_alternative<bool>(standard) && std::get<bool>(standard));
    case FieldKind::Text:
      return std::string(field.key == "technique" ? "sphere" : "another");
    case FieldKind::File:
      return std::string("another.exr");
    case FieldKind::Choice:
      // Not the last: a probe's mode "custom" needs an image, too.
      return std::holds_alternative<int>(standard) && std::get<int>(standard) == 1 ? 0 : 1;
    case FieldKind::Vector:
    case FieldKind::Direction:
      return glm::dvec3(0.5, 0.75, 0.25);
    case FieldKind::Color:
      return glm::vec3(0.5f, 0.25f, 0.75f);
    case FieldKind::Decode:
      return glm::dvec2(5.0, 2.0);
    case FieldKind::Names:
      return std::vector<std::string>{"lamp"};
    case FieldKind::Parameters:
      return std::map<std::string, ParameterValue>{{"power", 2.0}};
    case FieldKind::Box:
      return Box{{-3, -2, -1}, {1, 2, 3}};
    case FieldKind::BlendDistance:
      return BlendDistance{{1, 2, 3}, {4, 5, 6}};
    case FieldKind::Bevel:
      return Bevel{0.5, 0.25};
    case FieldKind::LatticeOrNone:
      return ProbeLattice{true, 0.75};
    case FieldKind::Occlusion:
      return BoxOcclusion{2.0, 3.0, 0.5};
    case FieldKind::ClearTo:
      return Clear(ClearToOpen{});
    case FieldKind::Parts:
      break;
  }
  return {};
}

std::set<std::string> ids(const Changes& changes) {
  std::set<std::string> names;
  for (const ChangeRow& row : changeRows()) {
    if (changes.*row.member) names.insert(std::string(row.id));
  }
  return names;
}

/// Each field of one part of a scene, changed alone.
template <typename Part>
void expectEachFieldWorks(const std::vector<FieldRow<Part>>& rows, const Scene& scene,
                          const std::function<Part&(Scene&)>& part, const std::vector<bool Changes::*>& ofThePart) {
  for (const FieldRow<Part>& row : rows) {
    if (row.get == nullptr) continue;
    SCOPED_TRACE(row.key);
    Scene changed = scene;
    const FieldValue value = another(row, row.get(part(changed)));
    row.set(part(changed), value);
    EXPECT_FALSE(changed == scene) << "equality does not know it";
    ASSERT_NO_THROW(validate(changed));
    const std::string text = sceneText(changed, "");
    EXPECT_THAT(text, HasSubstr("\"" + std::string(row.key) + "\"")) << "is not written";
    EXPECT_EQ(parseScene(text, "again", ""), changed) << "is not read: " << text;
    Changes expected;
    for (bool Changes::*kind : row.changes.empty() ? ofThePart : row.changes) expected.*kind = true;
    EXPECT_EQ(ids(difference(scene, changed)), ids(expected));
    EXPECT_FALSE(ids(expected).empty()) << "its row names no kind of change";
  }
}

/// A scene with one of each part.
Scene oneOfEach() {
  Scene scene;
  scene.models.push_back({"a.glb", {1, 0, 0}, {}, 1.0});  // moved: else its name alone is written
  scene.cameras.emplace_back();
  scene.lights.emplace_back();
  scene.materials["floor"];
  scene.objects["floor"];
  scene.mirrors["floor"];
  scene.probes.emplace_back();
  scene.probes[0].influence = Box{{-2, -2, -2}, {2, 2, 2}};
  scene.probes[0].bevel = Bevel{0.125, 0.125};
  scene.probes[0].occlusion = BoxOcclusion();
  scene.probes[0].lattice = ProbeLattice();
  scene.probes[0].image = "sky.exr";
  return scene;
}

TEST(SceneFields, EachIsReadWrittenComparedAndToldAsAChange) {
  const Scene scene = oneOfEach();
  const auto of = [](bool Changes::*kind) { return std::vector<bool Changes::*>{kind}; };
  const auto shape = of(&Changes::probeShape);
  expectEachFieldWorks<Scene>(sceneFields(), scene, [](Scene& s) -> Scene& { return s; }, {});
  expectEachFieldWorks<Scene>(anySkyFields(), scene, [](Scene& s) -> Scene& { return s; }, {});
  expectEachFieldWorks<ModelFile>(
      modelFields(), scene, [](Scene& s) -> ModelFile& { return s.models[0]; }, of(&Changes::models));
  expectEachFieldWorks<Camera>(
      cameraFields(), scene, [](Scene& s) -> Camera& { return s.cameras[0]; }, of(&Changes::cameras));
  expectEachFieldWorks<MaterialOverride>(
      materialFields(), scene, [](Scene& s) -> MaterialOverride& { return s.materials["floor"]; },
      of(&Changes::materials));
  expectEachFieldWorks<ObjectOverride>(
      objectFields(), scene, [](Scene& s) -> ObjectOverride& { return s.objects["floor"]; }, of(&Changes::objects));
  expectEachFieldWorks<PlanarMirror>(
      mirrorFields(), scene, [](Scene& s) -> PlanarMirror& { return s.mirrors["floor"]; }, of(&Changes::objects));
  expectEachFieldWorks<BlendDistance>(
      blendDistanceFields(), scene, [](Scene& s) -> BlendDistance& { return s.probes[0].blendDistance; }, shape);
  expectEachFieldWorks<Bevel>(
      bevelFields(), scene, [](Scene& s) -> Bevel& { return *s.probes[0].bevel; }, shape);
  expectEachFieldWorks<ProbeLattice>(
      latticeFields(), scene, [](Scene& s) -> ProbeLattice& { return *s.probes[0].lattice; }, shape);
  expectEachFieldWorks<BoxOcclusion>(
      occlusionFields(), scene, [](Scene& s) -> BoxOcclusion& { return *s.probes[0].occlusion; }, shape);
  expectEachFieldWorks<Box>(
      boxFields(), scene, [](Scene& s) -> Box& { return *s.probes[0].influence; }, shape);
  expectEachFieldWorks<Probe>(probeFields(), scene, [](Scene& s) -> Probe& { return s.probes[0]; }, {});
  for (const LightType type : {LightType::Directional, LightType::Point, LightType::Spot}) {
    Scene lit = scene;
    lit.lights[0].type = type;
    std::vector<FieldRow<Light>> rows;
    for (const FieldRow<Light>& row : lightFields()) {
      if (hasField(type, row)) rows.push_back(row);
    }
    expectEachFieldWorks<Light>(
        rows, lit, [](Scene& s) -> Light& { return s.lights[0]; }, of(&Changes::lights));
  }
}

TEST(SceneFields, OfTheSkiesToo) {
  const std::vector<bool Changes::*> sky = {&Changes::sky};
  Scene scene;
  expectEachFieldWorks<SkyGradient>(
      skyGradientFields(), scene, [](Scene& s) -> SkyGradient& { return std::get<SkyGradient>(s.sky); }, sky);
  scene.sky = SkyColor{glm::vec3(1.0f)};
  expectEachFieldWorks<SkyColor>(
      skyColorFields(), scene, [](Scene& s) -> SkyColor& { return std::get<SkyColor>(s.sky); }, sky);
  scene.sky = SkyImage{"sky.exr"};
  expectEachFieldWorks<SkyImage>(
      skyImageFields(), scene, [](Scene& s) -> SkyImage& { return std::get<SkyImage>(s.sky); }, sky);
}

bool isNumber(const FieldInfo& field) {
  return field.kind == FieldKind::Number || field.kind == FieldKind::Integer;
}

FieldValue numberValue(const FieldInfo& field, double number) {
  if (field.kind == FieldKind::Integer) return static_cast<int>(number);
  return field.singlePrecision ? FieldValue(static_cast<float>(number)) : FieldValue(number);
}

std::string rangeProblem(const FieldInfo& field, double number) {
  return errorText<FieldError>([&] { checkField(field, numberValue(field, number), {"part"}); });
}

TEST(SceneFields, NumbersEndWhereTheirRowsSay) {
  int ends = 0;
  for (const FieldPart& part : fieldParts()) {
    for (const auto& [field, standard] : part.fields) {
      if (!isNumber(*field) || !std::holds_alternative<double>(standard)) continue;
      const FieldRange r = field->range;
      SCOPED_TRACE(field->key);
      if (r.lowest > -limits::kNumber) {
        EXPECT_THAT(rangeProblem(*field, r.lowest - 1.0), HasSubstr("part." + std::string(field->key) + ": is "));
        if (r.aboveLowest) {
          EXPECT_NE(rangeProblem(*field, r.lowest), "");
        } else {
          EXPECT_NO_THROW(checkField(*field, numberValue(*field, r.lowest), {"part"}));
        }
        ++ends;
      }
      if (r.highest < limits::kNumber) {
        EXPECT_THAT(rangeProblem(*field, r.highest + 1.0), HasSubstr("must be"));
        if (r.belowHighest) {
          EXPECT_NE(rangeProblem(*field, r.highest), "");
        } else {
          EXPECT_NO_THROW(checkField(*field, numberValue(*field, r.highest), {"part"}));
        }
        ++ends;
      }
    }
  }
  EXPECT_GT(ends, 25);
}

TEST(SceneFields, RowsAreSound) {
  std::size_t rows = 0;
  for (const FieldPart& part : fieldParts()) {
    std::set<std::string_view> keys;
    for (const auto& [field, standard] : part.fields) {
      SCOPED_TRACE(std::string(part.path) + " " + std::string(field->key));
      ++rows;
      EXPECT_TRUE(keys.insert(field->key).second) << "twice";
      EXPECT_FALSE(field->help.empty());
      EXPECT_EQ(field->help.back(), '.') << "one sentence or more";
      EXPECT_EQ(field->help.find_first_of("|\n"), std::string_view::npos) << "would break the reference's table";
      // An empty name of a file, which is no default, aside.
      if (field->ifEmpty.empty()) {
        EXPECT_NO_THROW(checkField(*field, standard, {"part"})) << "the default";
      }
      const FieldRange form = formRange(*field);
      EXPECT_GE(form.lowest, field->range.lowest);
      EXPECT_LE(form.highest, field->range.highest);
      EXPECT_LT(form.lowest, form.highest);
      EXPECT_TRUE(field->kind != FieldKind::Choice || field->choices.size() > 1);
    }
  }
  EXPECT_GE(rows, 100u);
  EXPECT_EQ(sizeof(Changes), changeRows().size()) << "a kind of change without a row";
}

TEST(SceneReference, NamesEveryKeyOnce) {
  const std::string reference = sceneReferenceMarkdown(), json = sceneReferenceJson();
  for (const FieldPart& part : fieldParts()) {
    for (const auto& entry : part.fields) {
      EXPECT_THAT(reference, HasSubstr("\n| `" + std::string(entry.field->key) + "` | "));
      EXPECT_THAT(json, HasSubstr("\"key\": \"" + std::string(entry.field->key) + "\""));
    }
  }
  for (const ParameterRow& row : parameterRows()) {
    EXPECT_THAT(reference, HasSubstr("\n| `" + std::string(row.name) + "` | "));
  }
}

TEST(SceneReference, IsInTheDocument) {
  std::ifstream file(std::string(BOXPROBE_SOURCE_DIR) + "/data/scenes/README.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string begin = "<!-- fields -->\n", end = "<!-- /fields -->";
  const std::size_t from = text.str().find(begin), to = text.str().find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t start = from + begin.size();
  EXPECT_TRUE(text.str().substr(start, to - start) == sceneReferenceMarkdown())
      << "data/scenes/README.md is out of date; renew it from the source's folder with\n"
         "  build/release/bin/boxprobe info --fields | sed -i -e '/<!-- fields -->/,/<!-- .fields -->/{//!d}' -e "
         "'/<!-- "
         "fields -->/r /dev/stdin' data/scenes/README.md";
}

}  // namespace
}  // namespace boxprobe
