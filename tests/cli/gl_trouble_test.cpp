// OpenGL that is short of memory, refuses shaders or is too old: one line and exit status 1, never a crash; a program
// that goes on drawing goes on without reflections.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/math/sampling/filter_lobe.h"
#include "filters/vtk/draw/fewer_samplers.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/map_bytes.h"
#include "filters/vtk/maps/lattice_atlas.h"
#include "tests/cli/program.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// Set for this process and those it starts.
class Setting {
 public:
  Setting(const char* name, const char* value) : name_(name) { ::setenv(name, value, 1); }
  ~Setting() { ::unsetenv(name_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
};

class GlTrouble : public ::testing::Test {
 protected:
  /// Exit status 1, one line that says all of `mentioned`, no picture.
  void expectFailure(const std::vector<std::string>& sets, const std::vector<std::string>& mentioned) {
    std::vector<std::string> arguments = {"render", demoScene("room"), "-o", folder.path("out.png"), "--size", "64x36"};
    for (const std::string& set : sets) arguments.insert(arguments.end(), {"--set", set});
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("boxprobe: "));
    for (const std::string& text : mentioned) EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_THAT(folder.names(), SizeIs(0));
  }

  TemporaryFolder folder;
};

TEST_F(GlTrouble, MapsThatDoNotFitAreRefusedWithTheFigureBeforeTheyAreAllocated) {
  const Setting limit("BOXPROBE_TEXTURE_MEMORY", "100");
  const std::string size = "probes.room.faceSize=2048";
  expectFailure({size, "probes.room.bounces=1"},
                {"the maps of 1 probes", "2048 texels", "609 MB", "100 MB", "faceSize"});
  expectFailure({size}, {"961 MB", "100 MB", "bounces"});  // two: the first is held until the second is there
}

TEST_F(GlTrouble, ASceneRendererWithoutMemoryDrawsOnAndRecoversWithSmallerFaces) {
  const Setting limit("BOXPROBE_TEXTURE_MEMORY", "2");
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes[0].bounces = 1;
  picture.scene.probes[0].faceSize = 256;
  EXPECT_THROW(picture.show(cameraNamed(picture.scene, "main")), std::runtime_error);
  EXPECT_THAT(picture.renderer->error(), HasSubstr("of texture memory, and there are 2.0 MB"));
  EXPECT_EQ(picture.renderer->probeMemoryBytes(), 0u);
  EXPECT_FALSE(picture.renderer->workPending());
  EXPECT_EQ(picture.display().width, 64);
  picture.scene.probes[0].faceSize = 64;
  picture.show(cameraNamed(picture.scene, "main"));
  EXPECT_EQ(picture.renderer->error(), "");
  EXPECT_GT(picture.renderer->probeMemoryBytes(), 0u);
}

TEST_F(GlTrouble, WhatIsCountedIsWhatIsAllocated) {
  const auto window = makeWindow();
  for (const int size : {16, 64, 256}) {
    CubeTexture chain, distances, source;
    int levels = 1;
    while (size >> levels > 0) ++levels;
    chain.allocate(size, prefilterLevels(size), GL_RGBA16F);
    distances.allocate(size, 1, GL_R32F);
    source.allocate(size, levels, GL_RGBA16F);
    EXPECT_EQ(probeMapsBytes(size, true), chain.bytes() + distances.bytes());
    EXPECT_EQ(captureScratchBytes(size), source.bytes());
  }
  LatticeAtlas atlas;
  std::vector<std::shared_ptr<const DiffuseLattice>> lattices;
  for (std::size_t count = 1; count <= 5; ++count) {
    DiffuseLattice lattice;
    lattice.nodes = {2, 3, 4};
    lattice.texels.assign(24 * DiffuseLattice::kParts, glm::vec4(0.5f));
    lattices.push_back(std::make_shared<const DiffuseLattice>(std::move(lattice)));
    atlas.place(lattices.back());
    const glm::dvec3 texels = 1.0 / glm::dvec3(atlas.texelSize());
    EXPECT_NEAR(static_cast<double>(latticeAtlasBytes(count)), texels.x * texels.y * texels.z * 8.0, 100.0) << count;
  }
  atlas.release();
}

TEST_F(GlTrouble, AShaderThatDoesNotCompileIsAMessage) {
  for (const char* name : {"surface", "gpu/resolve_capture.glsl"}) {
    SCOPED_TRACE(name);
    const Setting broken("BOXPROBE_BREAK_SHADER", name);
    expectFailure({}, {"shader"});
  }
}

TEST_F(GlTrouble, ASceneRendererWithABrokenSurfaceShaderDrawsWithoutReflections) {
  ScenePicture plain = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  plain.renderer->setProbesEnabled(false);
  plain.show(cameraNamed(plain.scene, "main"));
  const ImageRgba8 expected = plain.display();

  const Setting broken("BOXPROBE_BREAK_SHADER", "surface");
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  EXPECT_THROW(picture.show(cameraNamed(picture.scene, "main")), std::runtime_error);
  EXPECT_THAT(picture.renderer->error(), HasSubstr("refuses the shader of a surface"));
  const ImageRgba8 image = picture.display();
  // VTK's own program where the other has VTK's own with our output: the same light, differently encoded at most.
  keepPicture(image, "broken");
  int lit = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) lit += image.pixels[i] > 8 ? 1 : 0;
  int litPlain = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); i += 4) litPlain += expected.pixels[i] > 8 ? 1 : 0;
  EXPECT_GT(lit, litPlain / 2);
}

/// The number before `what` in a line; 0 without it.
std::size_t countBefore(const std::string& line, const std::string& what) {
  const std::size_t at = line.find(what);
  if (at == std::string::npos || at < 2) return 0;
  const std::size_t start = line.find_last_of(' ', at - 2);
  return static_cast<std::size_t>(std::atoi(line.c_str() + start + 1));
}

/// Four probes of one room, whose influence covers all of it.
ScenePicture fourProbes(std::size_t impostors, std::size_t probes) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  Probe probe = picture.scene.probes[0];
  probe.faceSize = 64;
  probe.bounces = 1;
  probe.influence = Box{{-30.0, -20.0, -25.0}, {28.0, 24.0, 32.0}};
  picture.scene.probes.clear();
  const glm::dvec3 origins[] = {{0.7, 1.4, -0.5}, {-2.1, 1.1, 1.3}, {2.6, 2.2, 0.4}, {-0.9, 0.8, -1.7}};
  for (std::size_t i = 0; i < probes; ++i) {
    probe.name = std::string(1, static_cast<char>('a' + i));
    probe.origin = origins[i];
    probe.technique = i < impostors ? "impostor" : "box";
    picture.scene.probes.push_back(probe);
  }
  return picture;
}

struct Shown {
  ImageRgba8 image;
  std::string error, floor;  ///< what is said of the floor
};

Shown show(ScenePicture picture) {
  Camera camera = cameraNamed(picture.scene, "main");  // the floor alone, from above
  camera.position = {0.3, 2.1, 0.4};
  camera.target = {0.6, 0.0, -0.3};
  picture.show(camera);
  Shown shown;
  shown.image = picture.display();
  shown.error = picture.renderer->error();
  for (const std::string& remark : picture.renderer->remarks()) {
    if (remark.rfind("objects.floor: this OpenGL driver has too few texture units", 0) == 0) shown.floor = remark;
  }
  return shown;
}

// A driver of fewer and fewer texture units. What the line says of the floor is what is drawn: the picture is that of a
// scene whose author gave up the same.
TEST_F(GlTrouble, WhatTheDriverHasNoTextureUnitsForIsGivenUpInOrderAndSaid) {
  const Shown all = show(fourProbes(4, 4));
  EXPECT_EQ(all.floor, "");
  std::size_t impostorsBefore = 0, probesBefore = 0, lessImpostors = 0, lessProbes = 0;
  for (int units = 10; units >= 2; --units) {
    const Setting few("BOXPROBE_TEXTURE_UNITS", std::to_string(units).c_str());
    const Shown fewer = show(fourProbes(4, 4));
    EXPECT_EQ(fewer.error, "") << units << fewer.floor;
    const std::size_t byBox = countBefore(fewer.floor, "impostor");
    const std::size_t leftOut =
        countBefore(fewer.floor, "probe is left out") + countBefore(fewer.floor, "probes are left out");
    EXPECT_GE(byBox, impostorsBefore) << units;
    EXPECT_GE(leftOut, probesBefore) << units;
    EXPECT_TRUE(leftOut == 0 || byBox == 4) << "a probe before an impostor: " << fewer.floor;
    impostorsBefore = byBox;
    probesBefore = leftOut;
    if (leftOut == 0 && byBox > lessImpostors) {
      lessImpostors = byBox;
      EXPECT_NE(fewer.image.pixels, all.image.pixels) << units;
      EXPECT_EQ(fewer.image.pixels, show(fourProbes(4 - byBox, 4)).image.pixels) << fewer.floor;
    }
    if (leftOut == 3 && lessProbes < 3) {
      EXPECT_EQ(fewer.image.pixels, show(fourProbes(0, 1)).image.pixels) << fewer.floor;
    }
    lessProbes = std::max(lessProbes, leftOut);
  }
  EXPECT_GE(lessImpostors, 2u);
  EXPECT_EQ(lessProbes, 3u);
}

/// Components of a program's uniforms that stand in no block.
int componentsOf(GLuint program) {
  GLint uniforms = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  const std::map<GLint, int> each = {{GL_FLOAT_VEC2, 2}, {GL_FLOAT_VEC3, 3}, {GL_FLOAT_VEC4, 4},
                                     {GL_INT_VEC2, 2},   {GL_FLOAT_MAT3, 9}, {GL_FLOAT_MAT4, 16}};
  int sum = 0;
  for (GLuint i = 0; i < static_cast<GLuint>(uniforms); ++i) {
    GLint block = 0, type = 0, size = 0;
    glGetActiveUniformsiv(program, 1, &i, GL_UNIFORM_BLOCK_INDEX, &block);
    glGetActiveUniformsiv(program, 1, &i, GL_UNIFORM_TYPE, &type);
    glGetActiveUniformsiv(program, 1, &i, GL_UNIFORM_SIZE, &size);
    const auto known = each.find(type);
    if (block == -1) sum += size * (known == each.end() ? 1 : known->second);
  }
  return sum;
}

// OpenGL promises 1,024, of which this leaves half to debug views. Programs have place for sixteen lamps, whatever
// there are, whose numbers are 736 components and more where they stand in no block.
TEST_F(GlTrouble, ProgramsOfFourProbesWithLampsLeaveHalfOfThePromisedUniforms) {
  ScenePicture picture = fourProbes(0, 4);
  picture.scene.lamps = LampForm::Shapes;
  picture.show(cameraNamed(picture.scene, "main"));
  picture.display();
  int most = 0, ofLamps = 0;
  for (GLuint program = 1; program < 4000; ++program) {
    if (glIsProgram(program) == GL_FALSE) continue;
    most = std::max(most, componentsOf(program));
    ofLamps += glGetUniformBlockIndex(program, "bpLampBlock") != GL_INVALID_INDEX ? 1 : 0;
  }
  EXPECT_GE(ofLamps, 1);
  EXPECT_GT(most, 150);
  EXPECT_LE(most, 512);
}

// A program that does not compile at all, and then one that does.
TEST_F(GlTrouble, AProgramOfSeveralProbesThatIsRefusedIsOneOfFewer) {
  const Setting broken("BOXPROBE_BREAK_SHADER", "probes");
  const Shown fewer = show(fourProbes(4, 4));
  EXPECT_EQ(fewer.error, "");
  EXPECT_THAT(fewer.floor, HasSubstr("4 impostors are drawn by box, 3 probes are left out"));
  EXPECT_EQ(fewer.image.pixels, show(fourProbes(0, 1)).image.pixels);
}

std::shared_ptr<const DrawnProbe> drawnProbe(const char* technique, float importance) {
  DrawnProbe probe;
  probe.geometry.technique = *parseTechnique(technique);
  probe.geometry.parameters.sampling = 1;
  probe.geometry.importance = importance;
  return std::make_shared<DrawnProbe>(probe);
}

TEST_F(GlTrouble, EachStepGivesUpOneThingAndTheyEnd) {
  ProbeBinding whole;
  whole.lighting = Lighting::Probes;
  whole.openness = true;
  whole.movingLights = {3};
  whole.shadowLights = {1};
  whole.probes = {drawnProbe("impostor+raytraced", 5.0f), drawnProbe("box", 3.0f), drawnProbe("impostor", 2.0f)};
  std::vector<std::string> said;
  std::set<std::string> keys = {whole.variantKey()};
  std::shared_ptr<const ProbeBinding> at = std::make_shared<ProbeBinding>(whole);
  while (const auto less = withLess(*at)) {
    at = less;
    said.push_back(givenUpText(at->givenUp, 0).english());
    EXPECT_TRUE(keys.insert(at->variantKey()).second) << said.back();
    ASSERT_LT(said.size(), 20u);
  }
  EXPECT_THAT(said,
              ElementsAre("1 impostor is drawn by box", "2 impostors are drawn by box",
                          "2 impostors are drawn by box, rays are chosen without tables of light",
                          HasSubstr("of light, the sky is not occluded"), HasSubstr("occluded, 1 probe is left out"),
                          HasSubstr("occluded, 2 probes are left out"),
                          HasSubstr("2 probes are left out, moving objects throw no shadow")));
  ASSERT_THAT(at->probes, SizeIs(1));
  EXPECT_EQ(at->probes[0]->geometry.importance, 5.0f) << "the most important one stays";
  EXPECT_EQ(at->shadowLights, whole.shadowLights) << "what keeps light out of a room stays";
  EXPECT_TRUE(at->sky && at->weights) << "the sky had a share";
  EXPECT_FALSE(at->chooses("sampling", "luminance"));
}

TEST_F(GlTrouble, TexturesWithoutWhichItIsAnotherMaterialStay) {
  SurfaceMaterial whole;
  whole.finish.sheenColor = glm::vec3(0.3f);
  whole.finish.anisotropy = 0.5f;
  whole.tangents = true;
  const auto picture = std::make_shared<const SurfaceTexture>(TextureUse{}, false, nullptr);
  for (SurfaceSlot& slot : whole.slots) slot.texture = picture;
  std::shared_ptr<const SurfaceMaterial> at = std::make_shared<SurfaceMaterial>(whole);
  std::size_t steps = 0;
  while (const auto less = withTextureLess(*at)) {
    at = less;
    ASSERT_LT(++steps, 20u);
  }
  EXPECT_EQ(steps, kSurfaceSlots - 7u);
  for (const SurfaceSlotIndex slot : {kBaseColorSlot, kRoughMetalSlot, kEmissiveSlot, kTransmissionSlot, kCoatSlot,
                                      kSheenColorSlot, kIridescenceSlot}) {
    EXPECT_TRUE(at->slots[slot].texture) << slot;
  }
}

TEST_F(GlTrouble, TexturesThatAreNotSampledAreNotGivenUp) {
  const auto picture = std::make_shared<const SurfaceTexture>(TextureUse{}, false, nullptr);
  SurfaceMaterial glass;
  glass.finish.sheenColor = glm::vec3(0.3f);
  glass.glass.drawn = true;
  glass.slots[kSheenRoughnessSlot].texture = glass.slots[kSpecularSlot].texture = picture;
  EXPECT_EQ(withTextureLess(glass), nullptr) << "glass has no sheen";
  glass.slots[kNormalSlot].texture = picture;
  const auto less = withTextureLess(glass);
  ASSERT_NE(less, nullptr);
  EXPECT_FALSE(less->slots[kNormalSlot].texture);
  SurfaceMaterial brushed;
  brushed.finish.anisotropy = 0.5f;
  brushed.slots[kAnisotropySlot].texture = picture;
  EXPECT_EQ(withTextureLess(brushed), nullptr) << "without tangents nothing is brushed";
  brushed.tangents = true;
  EXPECT_NE(withTextureLess(brushed), nullptr);
}

TEST_F(GlTrouble, ADebugProgramThatIsRefusedHarmsNoPicture) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.show(cameraNamed(picture.scene, "main"));
  const ImageRgba8 before = picture.display();
  {
    const Setting broken("BOXPROBE_BREAK_SHADER", "debug");
    try {
      picture.renderer->explain(32, 30, 64, 36);
      ADD_FAILURE() << "explained by a program that writes no point";
    } catch (const WorkError& error) {
      EXPECT_THAT(error.what(), HasSubstr("refuses the shader that explains this surface"));
    }
    EXPECT_EQ(picture.renderer->error(), "");
    EXPECT_EQ(picture.display().pixels, before.pixels);
    SurfaceViewSettings view;
    view.view = 1;
    picture.renderer->setView(view);
    picture.display();
    EXPECT_THAT(picture.renderer->error(), HasSubstr("refuses the shader of this debug view"));
    picture.renderer->setView({});
    EXPECT_EQ(picture.display().pixels, before.pixels);
    EXPECT_EQ(picture.renderer->error(), "");
    for (const char* command : {"explain", "render"}) {
      std::vector<std::string> arguments = {command, demoScene("room"), "--size", "64x36"};
      if (std::string(command) == "explain") {
        arguments.insert(arguments.end(), {"--pixel", "32,30"});
      } else {
        arguments.insert(arguments.end(), {"--view", "level", "-o", folder.path("out.png")});
      }
      const Outcome outcome = runProgram(arguments);
      EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
      EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    }
  }
}

TEST_F(GlTrouble, ADriverThatIsTooOldIsAMessage) {
  const Setting old("MESA_GL_VERSION_OVERRIDE", "2.1");
  const Outcome outcome =
      runProgram({"render", demoScene("room"), "-o", folder.path("out.png"), "--size", "64x36", "--quiet"});
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
  EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("OpenGL"));
}

/// What the program says where it ends with `exitStatus` and one line.
std::string oneLine(const std::vector<std::string>& arguments, int exitStatus,
                    DisplayKind display = DisplayKind::Inherited) {
  const Outcome outcome = runProgram(arguments, display);
  EXPECT_EQ(outcome.exitStatus, exitStatus) << outcome.err;
  EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  return outcome.err;
}

TEST_F(GlTrouble, NoDriverIsAMessageForPicturesAndWindows) {
  // Where Mesa's drivers are files of their own, and where they are all in one library.
  const Setting none("LIBGL_DRIVERS_PATH", "/nonexistent"), unknown("GALLIUM_DRIVER", "none");
  const std::vector<std::string> render = {"render", demoScene("room"), "-o", folder.path("out.png"), "--quiet"};
  EXPECT_THAT(oneLine(render, 1), HasSubstr("no OpenGL on display"));
  EXPECT_THAT(oneLine({demoScene("room")}, 1), HasSubstr("libgl1-mesa-dri"));
  EXPECT_THAT(oneLine(render, 2, DisplayKind::Unset), HasSubstr("nothing to draw with"));
  EXPECT_THAT(folder.names(), SizeIs(0));
}

TEST_F(GlTrouble, OnWaylandAWindowTakesXOrSaysWhatToInstall) {
  const Setting platform("QT_QPA_PLATFORM", "wayland");
  const Setting display("WAYLAND_DISPLAY", "wayland-0");
  EXPECT_THAT(oneLine({demoScene("room")}, 2, DisplayKind::Unset), HasSubstr("install xwayland"));
  RunningProgram window({demoScene("room")});
  ASSERT_TRUE(window.waitUntilHandling(SIGTERM)) << "it opens, and asks for no plugin";
  ASSERT_TRUE(window.sendAtWork(SIGTERM));
  EXPECT_EQ(window.finish().exitStatus, 128 + SIGTERM);
}

TEST_F(GlTrouble, AWindowWithoutFontsSaysWhatToInstall) {
  const std::string none = folder.write("fonts.conf", "<?xml version=\"1.0\"?>\n<fontconfig/>\n");
  const Setting fonts("FONTCONFIG_FILE", none.c_str());
  RunningProgram window({demoScene("room")});
  ASSERT_TRUE(window.waitUntilHandling(SIGTERM));
  ASSERT_TRUE(window.sendAtWork(SIGTERM));
  EXPECT_THAT(window.finish().err, HasSubstr("no fonts are installed"));
}

// A line that QSettings throws at.
TEST_F(GlTrouble, ASettingsFileNeverKeepsTheWindowFromOpening) {
  const std::string broken = "[General]\nwindowDocks=@Variant(\\0\\0\\0\\t\\x7f\\xff\\xff\\xff)\n";
  std::filesystem::create_directories(folder.path("Boxprobe"));
  folder.write("Boxprobe/preferences.ini", broken);
  const Setting home("BOXPROBE_TEST_CONFIG_HOME", folder.path("").c_str());
  RunningProgram window({demoScene("room")});
  ASSERT_TRUE(window.waitUntilHandling(SIGTERM));
  ASSERT_TRUE(window.sendAtWork(SIGTERM));
  const Outcome outcome = window.finish();
  EXPECT_EQ(outcome.exitStatus, 128 + SIGTERM) << outcome.err;
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("preferences.ini: cannot be read as settings"), HasSubstr("preferences.ini.unreadable")));
  EXPECT_EQ(readFile(folder.path("Boxprobe/preferences.ini.unreadable")), broken);
}

}  // namespace
}  // namespace boxprobe::test
