// Probes on ordinary VTK actors (filters/vtk/actors) against the program's own picture of the same room, by every
// technique and under each of VTK's mappers; taken off, VTK's own bytes again; and what is said where it cannot work.
#include "filters/vtk/actors/actor_probes.h"

#include <gtest/gtest.h>
#include <vtkActorCollection.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include <vtkCompositePolyDataMapper.h>
#else
#include <vtkCompositePolyDataMapper2.h>
#endif

#include <cstdio>
#include <cstdlib>

#include "filters/core/base/errors.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/gl/window_pixels.h"
#include "tests/bench/stock_renderer.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 320, kHeight = 180;

/// The room as the program draws it, and the same window with a renderer that might be anybody's.
class RoomOfOrdinaryActors : public testing::Test {
 protected:
  RoomOfOrdinaryActors() : room_(ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight)) {
    room_.renderer->setFrameLimit(1);
    room_.show(room_.scene.cameras.front());
    ours_ = room_.renderer->renderer();
    ours_->DrawOff();
    theirs_->SetActiveCamera(ours_->GetActiveCamera());
    vtkNew<vtkLight> dark;
    dark->SetIntensity(0.0);
    theirs_->AddLight(dark);
    vtkActorCollection* actors = ours_->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
      actors_.push_back(bench::stockActor(actor));
      theirs_->AddActor(actors_.back());
      // The room's walls are unlit: a picture that shines, under an index of refraction that reflects nothing.
      vtkProperty* property = actors_.back()->GetProperty();
      if (property->GetTexture("emissiveTex") != nullptr) property->SetBaseIOR(1.0);
    }
    room_.window->AddRenderer(theirs_);
  }
  ~RoomOfOrdinaryActors() override { room_.window->RemoveRenderer(theirs_); }

  ImageRgba8 program() {
    theirs_->DrawOff();
    ours_->DrawOn();
    room_.show(room_.scene.cameras.front());
    ImageRgba8 image = room_.display();
    ours_->DrawOff();
    theirs_->DrawOn();
    return image;
  }
  ImageRgba8 theirs() {
    room_.window->Render();
    return windowPixels(room_.window);
  }
  void addAll(ActorProbes& probes) {
    for (const auto& actor : actors_) probes.addActor(actor);
  }

  ScenePicture room_;
  vtkRenderer* ours_ = nullptr;
  vtkNew<vtkRenderer> theirs_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

/// Largest difference of a channel of colour, in steps of 1/255.
int farthest(const ImageRgba8& a, const ImageRgba8& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  int most = 0;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    if (i % 4 != 3) most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  }
  return most;
}

/// Each projection, and each way to look up a lobe through the box.
std::vector<std::string> everyTechnique() {
  std::vector<std::string> ids;
  for (const ProjectionRow& row : projectionRows()) ids.emplace_back(row.id);
  for (const EvaluationRow& row : evaluationRows()) {
    if (row.id != "none") ids.emplace_back(row.id == "auto" ? "auto" : "box+" + std::string(row.id));
  }
  return ids;
}

TEST_F(RoomOfOrdinaryActors, LookAsTheProgramDrawsThemByEveryTechnique) {
  const ImageRgba8 stock = theirs();
  keepPicture(stock, "actors_stock");
  ActorProbes probes(theirs_);
  probes.setEmission(true);
  probes.setTone(Tone::None);  // the curve of the program's window
  probes.addProbe(room_.scene.probes.front());
  addAll(probes);
  for (const std::string& id : everyTechnique()) {
    Probe& probe = room_.scene.probes.front();
    probe.technique = id;
    probe.parameters.clear();
    // What the program smooths after the frame is no part of anybody's actor.
    for (const ParameterRow* row : parametersOf(*parseTechnique(id))) {
      if (row->name == "blur") probe.parameters["blur"] = false;
    }
    const ImageRgba8 wanted = program();
    probes.setMaps(0, room_.renderer->shownMaps("room"));  // reflections within reflections are of this technique, too
    probes.setProbe(0, probe);
    const ImageRgba8 drawn = theirs();
    EXPECT_EQ(probes.error(), "") << id;
    EXPECT_LE(farthest(wanted, drawn), 1) << id;
    EXPECT_GT(farthest(stock, drawn), 100) << id;
    if (id == "box") keepPicture(drawn, "actors_box");
  }
}

TEST_F(RoomOfOrdinaryActors, AreCapturedAsTheProgramCapturesThem) {
  room_.scene.probes.front().bounces = 2;
  const ImageRgba8 wanted = program();
  ActorProbes probes(theirs_);
  probes.setEmission(true);
  probes.setTone(Tone::None);  // the curve of the program's window
  probes.addProbe(room_.scene.probes.front());
  vtkActorCollection* actors = ours_->GetActors();
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    // The spheres are hidden from probes by the scene; nothing else is as small and not flat.
    const double* b = actors_[i]->GetBounds();
    const bool sphere = b[1] - b[0] < 2.0 && b[3] - b[2] < 2.0 && b[3] - b[2] > 0.1 && b[5] - b[4] < 2.0;
    probes.addActor(actors_[i], !sphere);
  }
  ASSERT_EQ(actors->GetNumberOfItems(), static_cast<int>(actors_.size()));
  ASSERT_TRUE(probes.capture()) << probes.error();
  const ImageRgba8 drawn = theirs();
  keepPicture(wanted, "actors_program");
  keepPicture(drawn, "actors_captured");
  std::printf("captured by the actors' probes: at most %d/255 off the program's picture\n", farthest(wanted, drawn));
  EXPECT_LE(farthest(wanted, drawn), 1);
}

// The one that draws all blocks at once; since 9.3 the name without the number is its own.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using CompositeMapper = vtkCompositePolyDataMapper;
#else
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

vtkSmartPointer<vtkMapper> compositeMapper(vtkPolyData* data) {
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, data);
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}

vtkSmartPointer<vtkMapper> glyphMapper(vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(where);
  mapper->SetSourceData(data);
  mapper->SetScaling(false);
  mapper->SetOrient(false);
  return mapper;
}

TEST_F(RoomOfOrdinaryActors, LookTheSameUnderEachMapper) {
  const ImageRgba8 wanted = program();
  ActorProbes probes(theirs_);
  probes.setEmission(true);
  probes.setTone(Tone::None);  // the curve of the program's window
  probes.addProbe(room_.scene.probes.front());
  probes.setMaps(0, room_.renderer->shownMaps("room"));
  addAll(probes);
  std::vector<vtkSmartPointer<vtkMapper>> plain;
  for (const auto& actor : actors_) plain.emplace_back(actor->GetMapper());
  using Maker = vtkSmartPointer<vtkMapper> (*)(vtkPolyData*);
  const std::vector<std::pair<std::string, Maker>> kinds = {{"composite", compositeMapper}, {"glyph", glyphMapper}};
  for (const auto& [name, make] : kinds) {
    probes.removeAllActors();
    for (std::size_t i = 0; i < actors_.size(); ++i) {
      const auto mapper = make(vtkPolyDataMapper::SafeDownCast(plain[i])->GetInput());
      mapper->ScalarVisibilityOff();
      actors_[i]->SetMapper(mapper);
    }
    const ImageRgba8 stock = theirs();
    addAll(probes);
    const ImageRgba8 drawn = theirs();
    keepPicture(drawn, "actors_" + name);
    EXPECT_EQ(probes.error(), "") << name;
    std::printf("%s: at most %d/255 off the program's picture\n", name.c_str(), farthest(wanted, drawn));
    EXPECT_LE(farthest(wanted, drawn), 1) << name;
    EXPECT_GT(farthest(stock, drawn), 100) << name;
    probes.removeAllActors();
    EXPECT_EQ(theirs().pixels, stock.pixels) << name;
  }
}

TEST_F(RoomOfOrdinaryActors, AreVtksOwnAgainWhenTheProbesAreTakenOff) {
  const ImageRgba8 stock = theirs();
  {
    ActorProbes probes(theirs_);
    probes.addProbe(room_.scene.probes.front());
    addAll(probes);
    ASSERT_TRUE(probes.capture()) << probes.error();
    EXPECT_NE(theirs().pixels, stock.pixels);
    probes.removeAllActors();
    EXPECT_EQ(theirs().pixels, stock.pixels);
    addAll(probes);
    EXPECT_NE(theirs().pixels, stock.pixels);
  }
  EXPECT_EQ(theirs().pixels, stock.pixels);
  for (const auto& actor : actors_) EXPECT_EQ(actor->GetPropertyKeys(), nullptr);
}

// Lamps' falloff and emission are VTK's: a surface that reflects nothing looks as without probes.
TEST_F(RoomOfOrdinaryActors, KeepTheirLampsAndEmission) {
  theirs_->RemoveAllLights();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetPosition(0.5, 2.0, 0.5);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(70.0);
  lamp->SetExponent(3.0);
  lamp->SetAttenuationValues(0.5, 0.1, 0.2);
  theirs_->AddLight(lamp);
  for (const auto& actor : actors_) {
    actor->GetProperty()->SetMetallic(0.0);
    actor->GetProperty()->SetBaseIOR(1.0);  // no reflection
    actor->GetProperty()->SetRoughness(1.0);
    actor->GetProperty()->SetEmissiveFactor(1.0, 1.0, 1.0);  // VTK's default, without effect there
  }
  const ImageRgba8 stock = theirs();
  keepPicture(stock, "actors_lamp");
  ActorProbes probes(theirs_);
  addAll(probes);
  EXPECT_LE(farthest(theirs(), stock), 1);
  EXPECT_EQ(probes.error(), "");
  ImageRgba8 black = stock;
  black.pixels.assign(stock.pixels.size(), 0);
  EXPECT_GT(farthest(stock, black), 60);
}

TEST_F(RoomOfOrdinaryActors, SayWhatIsMissing) {
  const ImageRgba8 stock = theirs();
  ActorProbes probes(theirs_);
  probes.addProbe(room_.scene.probes.front());
  addAll(probes);
  // Text that is there twice: the splice does not guess which is meant. (A comment, so that VTK's own still compiles.)
  constexpr const char* kLine = "//VTK::Light::Impl";
  vtkShaderProperty* shader = actors_.front()->GetShaderProperty();
  shader->AddFragmentShaderReplacement(
      kLine, true, std::string("// vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;\n  ") + kLine, false);
  theirs();
  EXPECT_NE(probes.error().find("2 places in place of 1"), std::string::npos) << probes.error();
  shader->ClearFragmentShaderReplacement(kLine, true);
  probes.clearError();
  theirs();
  EXPECT_EQ(probes.error(), "");

  probes.removeAllActors();
  probes.clearError();
  setenv("BOXPROBE_BREAK_SHADER", "surface", 1);
  addAll(probes);
  EXPECT_EQ(theirs().pixels, stock.pixels);
  unsetenv("BOXPROBE_BREAK_SHADER");
  EXPECT_NE(probes.error().find("refuses the shader"), std::string::npos) << probes.error();
}

// The driver is asked for the text that it gets. A replacement of the program's own is applied to that after the
// splice, and this one finds its words in the splice alone, so VTK's own program still compiles.
TEST_F(RoomOfOrdinaryActors, AreVtksOwnWhereTheirReplacementsBreakTheSplice) {
  const ImageRgba8 stock = theirs();
  ActorProbes probes(theirs_);
  probes.addProbe(room_.scene.probes.front());
  probes.setMaps(0, room_.renderer->shownMaps("room"));
  addAll(probes);
  const ImageRgba8 lit = theirs();
  EXPECT_GT(farthest(stock, lit), 100);
  EXPECT_EQ(probes.error(), "");
  constexpr const char* kOurs = "bpOutput(color)";
  for (const auto& actor : actors_) {
    actor->GetShaderProperty()->AddFragmentShaderReplacement(kOurs, false, "noFunction(color)", false);
  }
  EXPECT_EQ(theirs().pixels, stock.pixels);
  EXPECT_NE(probes.error().find("refuses the shader"), std::string::npos) << probes.error();

  probes.removeAllActors();
  probes.clearError();
  for (const auto& actor : actors_) {
    actor->GetShaderProperty()->ClearFragmentShaderReplacement(kOurs, false);
    actor->GetShaderProperty()->AddFragmentShaderReplacement(kOurs, false, "0.5 * bpOutput(color)", false);
  }
  addAll(probes);
  const ImageRgba8 dimmed = theirs();
  EXPECT_EQ(probes.error(), "");
  int off = 0;
  for (std::size_t i = 0; i < lit.pixels.size(); ++i) {
    // What is brighter than the display is cut off after the replacement.
    if (i % 4 == 3 || lit.pixels[i] == 255) continue;
    off = std::max(off, std::abs(int{lit.pixels[i]} / 2 - int{dimmed.pixels[i]}));
  }
  EXPECT_LE(off, 1);
  EXPECT_GT(farthest(lit, dimmed), 100);
}

TEST_F(RoomOfOrdinaryActors, RefuseWhatIsNoProbe) {
  ActorProbes probes(theirs_);
  Probe probe = room_.scene.probes.front();
  probe.technique = "bix";
  EXPECT_THROW(probes.addProbe(probe), InputError);
  probe.technique = "box";
  probe.mode = ProbeMode::Realtime;
  EXPECT_THROW(probes.addProbe(probe), InputError);
  EXPECT_TRUE(probes.probes().empty());
  EXPECT_THROW(probes.setMaps(0, std::shared_ptr<const ProbeMaps>()), InputError);
  vtkNew<vtkRenderer> nowhere;
  ActorProbes unseen(nowhere);
  EXPECT_THROW(unseen.capture(), InputError);
}

}  // namespace
