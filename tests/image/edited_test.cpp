// An edited scene shows what a fresh start of it shows: every field of the scene file, one after the other, in the room
// of odd_room.h. And where another capture would be made, its key says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "filters/core/base/errors.h"
#include "tests/image/edited_room.h"

namespace boxprobe::test {
namespace {

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
  // Each probe has a third of the fields. Those of a custom probe's picture come last, so that they move no others.
  std::vector<FieldRow<Probe>> fields = probeFields();
  std::stable_partition(fields.begin(), fields.end(), [](const FieldRow<Probe>& row) {
    return row.key != "cubeView" && row.key != "imageRotationDegrees";
  });
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    addSteps<Probe>(
        steps, "probe " + scene.probes[i].name, scene, everyNth(fields, 3, i),
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
  std::set<std::string> unseen;  ///< fields whose edit nobody can see in this room
};
Found expectFresh(const OddRoom& room, const std::vector<Step>& steps, bool traced = false) {
  Found found;
  Shown edited(room, traced), fresh(room, traced);
  const ImageRgbaF before = edited.picture();
  const ImageRgba8 seenBefore = edited.display();
  const auto mapsBefore = edited.maps("a");
  const std::string keyBefore = edited.key("a");
  EXPECT_EQ(keyBefore.empty(), room.scene.probes.empty());
  for (const Step& step : steps) {
    SCOPED_TRACE(step.field);
    edited.edit(step.scene);
    const ImageRgbaF shown = edited.picture();
    const ImageRgba8 seen = edited.display();
    fresh.startAgain(step.scene);
    const ImageRgbaF expected = fresh.picture();
    const ImageRgba8 seenFresh = fresh.display();
    EXPECT_LE(farthest(shown, expected), 1) << "differs from a fresh start";
    EXPECT_LE(farthest(seen, seenFresh), 1) << "is seen otherwise than after a fresh start";
    const bool visible = farthest(before, expected) > 1 || farthest(seenBefore, seenFresh) > 1;
    found.visible += visible ? 1 : 0;
    if (!visible) found.unseen.insert(step.field);
    keepPicture(seen, "edited_" + step.field);
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
  OddRoom room = oddRoom();
  room.scene.lights[2].range = 5.1;
  const Found found = expectFresh(room, sceneSteps(room.scene));
  EXPECT_GE(found.visible, 40);
  EXPECT_GE(found.recaptured, 25);
  const std::set<std::string> unseen = {// Of glass, which the floor and the paint are not.
                                        "floor.attenuationColor", "floor.glass", "floor.ior", "floor.thickness",
                                        "paint.attenuationDistance", "paint.thin",
                                        // Of pictures of normals, which no material has.
                                        "floor.normalScale", "glass.normalScale",
                                        // Of shadows and of planar mirrors, which this room has none of.
                                        "lights[0].angleDegrees", "lights[2].radius", "lights[2].shadowLevel",
                                        "lights[2].levelsPerUnit", "scene.mirrorBudget",
                                        // Less than two of 255 steps of light.
                                        "glass.thickness",
                                        // Of what is open or traced: seen in the test below.
                                        "scene.background", "scene.backgroundColor", "scene.groundShadow",
                                        "scene.ambientOcclusion", "scene.energy"};
  EXPECT_THAT(found.unseen, ::testing::UnorderedElementsAreArray(unseen));
}

// Without its north wall the room shows the background, and the sky is partly hidden.
TEST(Edited, OfAnOpenRoomTheBackgroundAndWhatIsTraced) {
  OddRoom room = oddRoom();
  Scene& scene = room.scene;
  scene.objects["north"].visible = false;
  scene.background = Background::Color;
  scene.materials["west"].metallic = 1.0f;
  scene.materials["west"].roughness = 0.8f;
  scene.probes.clear();
  std::vector<Step> steps;
  for (Step& step : sceneSteps(scene)) {
    const std::string part = step.field.substr(0, step.field.find_first_of(".["));
    if (part == "scene" || part == "sky") steps.push_back(std::move(step));
  }
  const Found found = expectFresh(room, steps, true);
  EXPECT_THAT(found.unseen, ::testing::UnorderedElementsAre("scene.mirrorBudget")) << "there is no planar mirror";
}

// Reflections within reflections: a second bounce shows the first one's by box, weight and technique. Without a sky, of
// whose light boxes leave a share to a first capture.
TEST(Edited, BouncesFollowBoxesAndTechniques) {
  OddRoom room = oddRoom();
  room.scene.sky = SkyColor{};
  for (Probe& probe : room.scene.probes) probe.bounces = 2;
  std::vector<FieldRow<Probe>> rows;
  for (const FieldRow<Probe>& row : probeFields()) {
    for (const auto kind : {&Changes::probeShape, &Changes::probeTechnique}) {
      if (std::find(row.changes.begin(), row.changes.end(), kind) != row.changes.end()) rows.push_back(row);
    }
  }
  ASSERT_GE(rows.size(), 10u);
  std::vector<Step> steps;
  for (std::size_t i = 0; i < room.scene.probes.size(); ++i) {
    addSteps<Probe>(
        steps, "probe " + room.scene.probes[i].name, room.scene, everyNth(rows, room.scene.probes.size(), i),
        [i](Scene& s) -> Probe& { return s.probes[i]; }, [](const auto& row) { return valueOfKind(row.kind); });
  }
  for (const char* technique : {"sphere", "box+footprint4"}) {
    Step step{std::string("technique ") + technique, room.scene};
    step.scene.probes[0].technique = technique;
    steps.push_back(std::move(step));
  }
  EXPECT_GE(steps.size(), 10u);
  const Found found = expectFresh(room, steps);
  EXPECT_GE(found.visible, 5);
  EXPECT_GE(found.recaptured, 2) << "captures that an edit of a box or technique makes others";
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

/// The key of probe "a" in the odd room, its pillar's mesh and material changed first. Nothing is captured.
std::string keyWith(const std::function<void(Mesh&, Material&, Instance&)>& change) {
  const OddRoom room = oddRoom();
  auto model = std::make_shared<Model>(*room.model);
  for (Instance& instance : model->instances) {
    if (instance.node != "pillar") continue;
    Mesh& mesh = model->meshes[static_cast<std::size_t>(instance.mesh)];
    change(mesh, model->materials[static_cast<std::size_t>(mesh.material)], instance);
  }
  Scene scene = room.scene;
  // Glass by the scene alone: what the model's material would be as glass shows then.
  MaterialOverride& paint = scene.materials["paint"];
  paint.transmission = 0.7f;
  paint.thickness = 0.4f;
  paint.attenuationDistance = 0.6f;
  ScenePicture picture(scene, 16, 16);
  picture.renderer->setModels({model});
  picture.renderer->sync(scene, Changes::all());
  const auto keys = picture.renderer->bakeKeys("a");
  return keys.empty() ? std::string() : keys.back();
}

TEST(Edited, EveryPartOfAMeshAndItsMaterialChangesTheKey) {
  using Change = std::function<void(Mesh&, Material&, Instance&)>;
  const auto image = [](int shade) {
    const auto byte = static_cast<std::uint8_t>(shade);
    return std::make_shared<const ImageRgba8>(ImageRgba8{1, 1, {byte, 90, 40, 200}, "made"});
  };
  std::vector<std::pair<std::string, Change>> changes = {
      {"positions", [](Mesh& m, Material&, Instance&) { m.positions[0].x += 0.07f; }},
      {"normals", [](Mesh& m, Material&, Instance&) { m.normals[0] = glm::vec3(0.6f, 0.8f, 0.0f); }},
      {"tangents",
       [](Mesh& m, Material&, Instance&) {
         m.tangents.assign(m.positions.size(), {1, 0, 0, -1});
       }},
      {"uv",
       [](Mesh& m, Material&, Instance&) {
         m.uv.assign(m.positions.size(), {0.3f, 0.4f});
       }},
      {"uv1",
       [](Mesh& m, Material&, Instance&) {
         m.uv1.assign(m.positions.size(), {0.3f, 0.4f});
       }},
      {"colors",
       [](Mesh& m, Material&, Instance&) {
         m.colors.assign(m.positions.size(), {0.3f, 0.4f, 0.5f, 1.0f});
       }},
      {"indices", [](Mesh& m, Material&, Instance&) { std::swap(m.indices[0], m.indices[1]); }},
      {"place", [](Mesh&, Material&, Instance& i) { i.worldFromModel[3][0] += 0.11; }},
      {"wrapS",
       [&](Mesh&, Material& m, Instance&) {
         m.baseColorTexture = {image(7), Wrap::ClampToEdge};
       }},
      {"wrapT",
       [&](Mesh&, Material& m, Instance&) {
         m.baseColorTexture = {image(7), {}, Wrap::ClampToEdge};
       }},
      {"uvSet",
       [&](Mesh&, Material& m, Instance&) {
         m.baseColorTexture = {image(7), {}, {}, 1};
       }},
      {"uvTransform",
       [&](Mesh&, Material& m, Instance&) {
         m.baseColorTexture.image = image(7);
         m.baseColorTexture.uvTransform[2].x = 0.25f;
       }},
      {"nearest",
       [&](Mesh&, Material& m, Instance&) {
         m.baseColorTexture.image = image(7);
         m.baseColorTexture.nearest = true;
       }},
  };
  const auto add = [&changes](const std::string& name, const std::function<void(Material&)>& set) {
    changes.emplace_back(name, [set](Mesh&, Material& m, Instance&) { set(m); });
  };
  add("baseColor", [](Material& m) { m.baseColor.g += 0.1f; });
  add("alpha", [](Material& m) { m.baseColor.a = 0.6f; });
  add("metallic", [](Material& m) { m.metallic = 0.31f; });
  add("roughness", [](Material& m) { m.roughness = 0.37f; });
  add("emissive", [](Material& m) { m.emissive.b = 0.2f; });
  add("normalScale", [](Material& m) { m.normalScale = 0.4f; });
  add("occlusionStrength", [](Material& m) { m.occlusionStrength = 0.4f; });
  add("coat", [](Material& m) { m.coat = 0.23f; });
  add("coatRoughness", [](Material& m) { m.coatRoughness = 0.23f; });
  add("coatNormalScale", [](Material& m) { m.coatNormalScale = 0.23f; });
  add("transmission", [](Material& m) { m.transmission = 0.23f; });
  add("ior", [](Material& m) { m.ior = 1.7f; });
  add("specular", [](Material& m) { m.specular = 0.7f; });
  add("thin", [](Material& m) { m.thin = false; });
  add("thickness", [](Material& m) { m.thickness = 0.7f; });
  add("attenuationDistance", [](Material& m) { m.attenuationDistance = 0.7f; });
  add("attenuationColor", [](Material& m) { m.attenuationColor.r = 0.3f; });
  add("unlit", [](Material& m) { m.unlit = true; });
  add("doubleSided", [](Material& m) { m.doubleSided = true; });
  add("alphaMode", [](Material& m) { m.alphaMode = AlphaMode::Mask; });
  add("alphaCutoff", [](Material& m) { m.alphaCutoff = 0.3f; });
  add("specularTint", [](Material& m) { m.finish.specularTint.g = 0.3f; });
  add("specularEdge", [](Material& m) { m.finish.specularEdge = 0.3f; });
  const auto addFinish = [&add](const std::string& name, const std::function<void(MaterialFinish&)>& set) {
    add(name, [set](Material& m) {
      m.finish.sheenColor = glm::vec3(0.4f);
      m.finish.anisotropy = 0.4f;
      m.finish.iridescence = 0.4f;
      set(m.finish);
    });
  };
  addFinish("all of the finish", [](MaterialFinish&) {});
  addFinish("sheenColor", [](MaterialFinish& f) { f.sheenColor.b = 0.3f; });
  addFinish("sheenRoughness", [](MaterialFinish& f) { f.sheenRoughness = 0.3f; });
  addFinish("anisotropy", [](MaterialFinish& f) { f.anisotropy = 0.3f; });
  addFinish("anisotropyRotation", [](MaterialFinish& f) { f.anisotropyRotation = 0.3f; });
  addFinish("iridescence", [](MaterialFinish& f) { f.iridescence = 0.3f; });
  addFinish("filmIor", [](MaterialFinish& f) { f.filmIor = 1.5f; });
  addFinish("filmThicknessMin", [](MaterialFinish& f) { f.filmThicknessMin = 150.0f; });
  addFinish("filmThicknessMax", [](MaterialFinish& f) { f.filmThicknessMax = 450.0f; });
  const std::size_t ofFinish = MaterialFinish().textures().size(), ofAll = Material().textures().size();
  for (std::size_t i = 0; i < ofFinish; ++i) {
    addFinish("texture of the finish " + std::to_string(i),
              [i, &image](MaterialFinish& f) { f.textures()[i]->image = image(9); });
  }
  for (std::size_t i = 0; i + ofFinish < ofAll; ++i) {
    add("texture " + std::to_string(i), [i, &image](Material& m) { m.textures()[i]->image = image(9); });
  }
  add("another image", [&image](Material& m) { m.textures()[0]->image = image(10); });
  // Each another than all the others: two inputs that share a place in the key are told apart, too.
  std::map<std::string, std::string> changeOf{{keyWith([](Mesh&, Material&, Instance&) {}), "nothing"}};
  EXPECT_NE(changeOf.begin()->first, "");
  for (const auto& [name, change] : changes) {
    const auto [at, added] = changeOf.emplace(keyWith(change), name);
    EXPECT_TRUE(added) << name << " has the key of " << at->second;
  }
  std::printf("%zu changes of a mesh, %zu keys\n", changes.size(), changeOf.size());
}

// With coverage for shadows, which is when a light's size counts: a further bounce shows what the first left of it.
TEST(Edited, EveryFieldOfALightChangesTheKey) {
  OddRoom room = oddRoom();
  for (Probe& probe : room.scene.probes) probe.bounces = 2;
  for (Light& light : room.scene.lights) light.shadows = LightShadows::CoverageAndMap;
  ScenePicture picture(room.scene, 16, 16);
  picture.renderer->setModels({room.model});
  const auto keyOf = [&picture](const Scene& scene) {
    picture.renderer->sync(scene, Changes::all());
    const auto keys = picture.renderer->bakeKeys("a");
    return keys.empty() ? std::string() : keys.back();
  };
  std::map<std::string, std::string> changeOf{{keyOf(room.scene), "nothing"}};
  EXPECT_NE(changeOf.begin()->first, "");
  int changes = 0;
  for (std::size_t i = 0; i < room.scene.lights.size(); ++i) {
    for (const FieldRow<Light>& row : lightFields()) {
      if (row.get == nullptr || row.key == "type" || !hasField(room.scene.lights[i].type, row)) continue;
      Scene scene = room.scene;
      const auto other = otherValue(row, row.get(scene.lights[i]), valueOfKind(row.kind));
      ASSERT_TRUE(other) << row.key;
      row.set(scene.lights[i], *other);
      const std::string name = std::to_string(i) + "." + std::string(row.key);
      const auto [at, added] = changeOf.emplace(keyOf(scene), name);
      EXPECT_TRUE(added) << name << " has the key of " << at->second;
      ++changes;
    }
  }
  EXPECT_GE(changes, 20);
}

}  // namespace
}  // namespace boxprobe::test
