// What a plain VTK program does with a renderer of its own, and what probes make of it: unlit and Phong actors, VTK's
// usual environment, assemblies, keys that are replaced, two viewports, rooms of any size, and objects that are
// missing.
#include <gtest/gtest.h>
#include <vtkActorCollection.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGLTFImporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkLight.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <cmath>
#include <cstdio>

#include "filters/core/base/errors.h"
#include "filters/vtk/actors/actor_probes.h"
#include "filters/vtk/gl/window_pixels.h"
#include "tests/image/vtk_room.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

TEST(VtkProgram, UnlitWallsAreReflectedAsTheyLook) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  const ImageRgba8 picture = room.picture();
  keepPicture(picture, "program_unlit");
  EXPECT_EQ(probes.error(), "");
  EXPECT_TRUE(probes.remarks().empty()) << probes.remarks().front();
  const auto wall = at(picture, kMirroredX, 40), mirrored = at(picture, kMirroredX, kMirroredY);
  std::printf("a wall of %d looks %d in the mirror\n", wall[0], mirrored[0]);
  expectNear(wall, {128, 128, 128}, 1);
  expectNear(mirrored, wall, 2);
}

TEST(VtkProgram, PhongIsReflectedAsItLooks) {
  const Room room;
  for (const auto& wall : room.others) {
    wall->GetProperty()->SetLighting(true);
    wall->GetProperty()->SetInterpolationToPhong();
    wall->GetProperty()->SetAmbient(1.0);
    wall->GetProperty()->SetDiffuse(0.0);
  }
  ActorProbes probes(room.renderer);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  const ImageRgba8 picture = room.picture();
  expectNear(at(picture, kMirroredX, kMirroredY), {128, 128, 128}, 2);
}

TEST(VtkProgram, AnExposureLeavesUnlitWallsAlike) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.setExposure(2.0);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {128, 128, 128}, 2);
}

TEST(VtkProgram, NoActorOfTheShippedModelsStopsACapture) {
  for (const char* name : {"six-faces", "room", "gallery", "furnished", "mirror-hall", "glass"}) {
    auto window = makeWindow(120, 120);
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    vtkNew<vtkGLTFImporter> importer;
    importer->SetFileName((std::string(BOXPROBE_DATA_DIR) + "/scenes/" + name + ".glb").c_str());
    importer->SetRenderWindow(window);
    importer->Update();
    Probe probe;
    probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
    probe.faceSize = 32;
    ActorProbes probes(renderer);
    probes.addProbe(probe);
    vtkActorCollection* actors = renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) probes.addActor(actor);
    EXPECT_TRUE(probes.capture()) << name << ": " << probes.error();
    window->Render();
    EXPECT_EQ(probes.error(), "") << name;
    window->RemoveRenderer(renderer);
  }
}

TEST(VtkProgram, WithoutProbesAndSkyAFloorIsBlack) {
  const Room room;
  ActorProbes probes(room.renderer);
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {0, 0, 0}, 0);
}

TEST(VtkProgram, CapturesSeeTheBackground) {
  const Room room;
  room.others[2]->VisibilityOff();  // the grey wall
  room.renderer->SetBackground(0.2, 0.6, 0.4);
  ActorProbes probes(room.renderer);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  const ImageRgba8 picture = room.picture();
  expectNear(at(picture, kMirroredX, 40), {51, 153, 102}, 1);
  expectNear(at(picture, kMirroredX, kMirroredY), {51, 153, 102}, 2);
  // It lights nothing where no probe has weight.
  probes.removeProbe(0);
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {0, 0, 0}, 0);
}

/// Different in each direction, smooth, up to 3.
vtkSmartPointer<vtkImageData> surroundings(int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width * 2.0 * 3.14159265, v = (y + 0.5) / height;
      auto* to = static_cast<float*>(image->GetScalarPointer(x, y, 0));
      to[0] = static_cast<float>(0.2 + 0.8 * v * (1.0 + std::cos(u)));
      to[1] = static_cast<float>(0.2 + 0.5 * (1.0 + std::sin(u)));
      to[2] = static_cast<float>(0.3 + 1.5 * (1.0 - v));
    }
  }
  return image;
}

struct Ball {
  Ball() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetColor(0.9, 0.8, 0.7);
    renderer->AddActor(actor);
    renderer->AutomaticLightCreationOff();
    renderer->UseImageBasedLightingOn();
    renderer->GetActiveCamera()->SetPosition(1.0, 0.6, 1.6);
    renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
    window->AddRenderer(renderer);
  }
  ~Ball() { window->RemoveRenderer(renderer); }
  ImageRgba8 picture() const {
    window->Render();
    return windowPixels(window);
  }
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow(160, 160);
  vtkNew<vtkOpenGLRenderer> renderer;
  vtkNew<vtkActor> actor;
};

/// VTK 9.1 shows a metal of roughness 0.6 a map baked for 0.48 (level 2.4 of 5), so that ours looks softer.
void expectVtksLight(const Ball& ball, const std::string& what, const std::vector<double>& metals) {
  for (const double roughness : {0.1, 0.6}) {
    for (const double metallic : metals) {
      ball.actor->GetProperty()->SetRoughness(roughness);
      ball.actor->GetProperty()->SetMetallic(metallic);
      const ImageRgba8 stock = ball.picture();
      ActorProbes probes(ball.renderer);
      probes.addActor(ball.actor);
      ASSERT_TRUE(probes.capture()) << probes.error();
      const ImageRgba8 ours = ball.picture();
      EXPECT_EQ(probes.error(), "");
      const std::string name = what + "_" + std::to_string(roughness).substr(0, 3) + (metallic > 0.0 ? "_metal" : "");
      keepPicture(stock, "environment_" + name + "_vtk");
      keepPicture(ours, "environment_" + name + "_ours");
      const double mean = meanDifference(stock, ours);
      std::printf("environment, %s: %.2f/255 off VTK's on average\n", name.c_str(), mean);
      EXPECT_LT(mean, roughness > 0.5 && metallic > 0.0 ? 7.0 : 1.5) << name;
      ImageRgba8 black = stock;
      black.pixels.assign(stock.pixels.size(), 0);
      EXPECT_GT(meanDifference(stock, black), 10.0);
    }
  }
}

TEST(VtkProgram, TheRenderersEnvironmentLightsWhereNoProbeDoes) {
  const Ball ball;
  vtkNew<vtkTexture> texture;
  texture->SetInputData(surroundings(128, 64));
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  ball.renderer->SetEnvironmentTexture(texture);
  expectVtksLight(ball, "upright", {0.0, 1.0});
  ball.renderer->SetEnvironmentUp(0, 0, 1);
  ball.renderer->SetEnvironmentRight(1, 0, 0);
  expectVtksLight(ball, "z_up", {0.0, 1.0});
}

// A picture of eight bits, as JPEG files are: sRGB by VTK's own flag, or by the texture's.
TEST(VtkProgram, SoDoesAPictureOfDisplayColours) {
  const Ball ball;
  const vtkSmartPointer<vtkImageData> light = surroundings(128, 64);
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(128, 64, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 128 * 64 * 3; ++i) {
    const float value = static_cast<float*>(light->GetScalarPointer())[i] / 3.0f;
    static_cast<unsigned char*>(picture->GetScalarPointer())[i] =
        static_cast<unsigned char>(std::lround(255.0f * std::min(value, 1.0f)));
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(picture);
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  ball.renderer->UseSphericalHarmonicsOff();
  ball.renderer->GetEnvMapIrradiance()->SetIrradianceSize(16);
  ball.renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.1f);
  ball.renderer->SetEnvironmentTexture(texture, true);
  expectVtksLight(ball, "flagged", {1.0});
}

TEST(VtkProgram, SoDoesACubeOfSixFaces) {
  const Ball ball;
  vtkNew<vtkTexture> texture;
  texture->CubeMapOn();
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  const std::array<Point, 6> colors = {
      {{1, 0.1, 0.1}, {0.1, 1, 0.1}, {0.1, 0.1, 1}, {1, 1, 0.1}, {0.1, 1, 1}, {1, 0.1, 1}}};
  for (int face = 0; face < 6; ++face) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(32, 32, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    for (int i = 0; i < 32 * 32; ++i) {
      for (int c = 0; c < 3; ++c) {
        const double shade = 0.5 + (i % 32) / 64.0 + 0.5 * (i / 32) / 64.0;
        image->SetScalarComponentFromDouble(
            i % 32, i / 32, 0, c, shade * colors[static_cast<std::size_t>(face)][static_cast<std::size_t>(c)]);
      }
    }
    texture->SetInputData(face, image);
  }
  ball.renderer->SetEnvironmentTexture(texture);
  ball.renderer->UseSphericalHarmonicsOff();  // VTK 9.1 cannot make them of a cube, and shows no diffuse light then
  ball.renderer->GetEnvMapIrradiance()->SetIrradianceSize(16);  // 20 s of a processor otherwise
  ball.renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.1f);
  expectVtksLight(ball, "cube", {0.0, 1.0});
}

TEST(VtkProgram, AnEnvironmentWithoutAnImageIsSaid) {
  const Ball ball;
  vtkNew<vtkTexture> texture;
  ActorProbes probes(ball.renderer);
  ball.renderer->SetEnvironmentTexture(texture);
  probes.addActor(ball.actor);
  probes.capture();
  EXPECT_NE(probes.error().find("environment texture has no image"), std::string::npos) << probes.error();
}

TEST(VtkProgram, RoomsOfAnySizeLookTheSame) {
  ImageRgba8 first;
  for (const double scale : {1.0, 1000.0, 0.001}) {
    const Room room(scale);
    ActorProbes probes(room.renderer);
    probes.addProbe(room.probe());
    room.addAll(probes);
    ASSERT_TRUE(probes.capture()) << probes.error();
    const ImageRgba8 picture = room.picture();
    keepPicture(picture, "program_scale_" + std::to_string(scale));
    if (first.pixels.empty()) first = picture;
    const double mean = meanDifference(first, picture);
    std::printf("a room %g times as large: %.3f/255 off on average\n", scale, mean);
    EXPECT_LT(mean, 0.3) << scale;
    expectNear(at(picture, kMirroredX, kMirroredY), {128, 128, 128}, 2);
  }
}

TEST(VtkProgram, AProbeThatLightsNothingSaysSo) {
  const Room room;
  ActorProbes probes(room.renderer);
  Probe probe = room.probe();
  probe.name = "fitted";
  probe.blendDistance = BlendDistance{};  // 1 from each face inwards: nothing is left for what lies in the faces
  probes.addProbe(probe);
  room.addAll(probes);
  ASSERT_TRUE(probes.capture());
  ASSERT_EQ(probes.remarks().size(), 1u);
  EXPECT_NE(probes.remarks().front().find("\"fitted\" lights nothing"), std::string::npos) << probes.remarks().front();
}

TEST(VtkProgram, PartsOfAnAssemblyReflect) {
  const Room room;
  room.renderer->RemoveActor(room.floor);
  room.floor->SetPosition(0.0, 0.5, 0.0);
  vtkNew<vtkAssembly> assembly, inner;
  inner->AddPart(room.floor);
  assembly->AddPart(inner);
  assembly->SetPosition(0.0, -0.5, 0.0);  // where it was
  room.renderer->AddActor(assembly);
  const ImageRgba8 stock = room.picture();
  {
    ActorProbes probes(room.renderer);
    probes.addProbe(room.probe());
    room.addAll(probes);
    ASSERT_TRUE(probes.capture()) << probes.error();
    for (int frame = 0; frame < 2; ++frame) {
      const ImageRgba8 picture = room.picture();
      keepPicture(picture, "program_assembly");
      expectNear(at(picture, kMirroredX, kMirroredY), {128, 128, 128}, 2);
    }
    EXPECT_EQ(probes.error(), "");
  }
  EXPECT_EQ(room.picture().pixels, stock.pixels);
}

TEST(VtkProgram, ReplacedKeysGetTheProbesAgain) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  const ImageRgba8 lit = room.picture();
  room.floor->SetPropertyKeys(nullptr);
  EXPECT_EQ(room.picture().pixels, lit.pixels);
  vtkNew<vtkInformation> others;
  room.floor->SetPropertyKeys(others);
  EXPECT_EQ(room.picture().pixels, lit.pixels);
}

TEST(VtkProgram, EachViewportReflectsByItsOwnCamera) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(room.probe());
  room.addAll(probes);
  ASSERT_TRUE(probes.capture()) << probes.error();
  // Each alone, over the whole window.
  room.look(room.renderer, -1.5);
  const ImageRgba8 left = room.picture();
  room.look(room.renderer, 1.5);
  const ImageRgba8 right = room.picture();
  EXPECT_GT(meanDifference(left, right), 5.0);
  vtkNew<vtkRenderer> second;
  second->AddActor(room.floor);
  for (const auto& wall : room.others) second->AddActor(wall);
  vtkNew<vtkLight> dark;
  dark->SetIntensity(0.0);
  second->AddLight(dark);
  room.look(second, 1.5);
  room.look(room.renderer, -1.5);
  room.window->SetSize(320, 160);
  room.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  room.window->AddRenderer(second);
  ImageRgba8 both;
  for (int frame = 0; frame < 3; ++frame) both = room.picture();
  keepPicture(both, "program_viewports");
  EXPECT_EQ(probes.error(), "");
  const auto half = [&both](int first) {
    ImageRgba8 part{160, 160, {}, {}};
    for (int y = 0; y < 160; ++y) {
      const auto row = both.pixels.begin() + (y * 320 + first) * 4;
      part.pixels.insert(part.pixels.end(), row, row + 160 * 4);
    }
    return part;
  };
  EXPECT_LT(meanDifference(half(0), left), 0.05);
  EXPECT_LT(meanDifference(half(160), right), 0.05);
  room.window->RemoveRenderer(second);
}

TEST(VtkProgram, AnActorIsLitByOneObject) {
  const Room room;
  ActorProbes first(room.renderer), second(room.renderer);
  first.addProbe(room.probe());
  room.addAll(first);
  second.addActor(room.floor);
  EXPECT_NE(second.error().find("another object lights this actor"), std::string::npos) << second.error();
  ASSERT_TRUE(first.capture()) << first.error();
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {128, 128, 128}, 2);
  EXPECT_EQ(first.error(), "");
}

TEST(VtkProgram, WhatIsMissingIsSaid) {
  ActorProbes none(nullptr);
  EXPECT_NE(none.error().find("null"), std::string::npos);
  EXPECT_THROW(none.capture(), InputError);
  none.addActor(nullptr);
  none.removeActor(nullptr);
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addActor(nullptr);
  EXPECT_NE(probes.error().find("null"), std::string::npos);
  probes.removeActor(nullptr);
  EXPECT_TRUE(probes.capture()) << probes.error();
}

TEST(VtkProgram, ACaptureBeforeAWidgetIsShownIsSaid) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;  // as a Qt widget has it
  window->SetReadyForRendering(false);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  ActorProbes probes(renderer);
  probes.addProbe(Probe{});
  EXPECT_FALSE(probes.capture());
  EXPECT_NE(probes.error().find("no OpenGL context yet"), std::string::npos) << probes.error();
  window->SetReadyForRendering(true);  // says so, and still has none
  EXPECT_FALSE(probes.capture());
  EXPECT_NE(probes.error().find("no OpenGL context yet"), std::string::npos) << probes.error();
}

}  // namespace
