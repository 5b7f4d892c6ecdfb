// What a plain VTK program may change, one thing after the other: which of it makes maps stale, which of it is another
// picture, and what the new maps hold, texel by texel.
#include <gtest/gtest.h>
#include <vtkAssembly.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderStepsPass.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <functional>
#include <glm/geometric.hpp>

#include "filters/vtk/maps/cube_transfer.h"
#include "tests/image/vtk_room.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

Probe smallProbe(const Room& room) {
  Probe probe = room.probe();
  probe.faceSize = 16;
  probe.samplesPerPixel = 1;
  return probe;
}

struct Change {
  const char* what;
  std::function<void()> make;
  bool stale = true, picture = true;
};

TEST(ActorChanges, EachIsStaleOrAnotherPictureOrNeither) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(smallProbe(room));
  room.addAll(probes);
  probes.setRefinement({64, 0.0, 0.0});
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(120.0);  // all around, so that the room stays as it looks
  lamp->SetPosition(0.1, 0.2, 0.3);
  lamp->SetIntensity(0.3);
  room.renderer->AddLight(lamp);
  ASSERT_TRUE(probes.capture()) << probes.error();
  room.window->Render();
  vtkProperty* wall = room.others[2]->GetProperty();
  vtkProperty* floor = room.floor->GetProperty();
  vtkRenderer* renderer = room.renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  auto* input = vtkPolyDataMapper::SafeDownCast(room.others[0]->GetMapper());
  vtkNew<vtkTexture> texture;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  texture->SetInputData(image);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.1);
  const auto set = [&probes](const std::function<void(Probe&)>& edit) {
    Probe next = probes.probes()[0];
    edit(next);
    probes.setProbe(0, next);
  };
  const std::vector<Change> changes = {
      {"nothing", [] {}, false, false},
      {"colour", [&] { wall->SetColor(0.2, 0.3, 0.4); }},
      {"the same colour", [&] { wall->SetColor(0.2, 0.3, 0.4); }, false, false},
      {"ambient colour", [&] { wall->SetAmbientColor(0.2, 0.3, 0.5); }},
      {"diffuse colour", [&] { wall->SetDiffuseColor(0.2, 0.35, 0.4); }},
      {"specular colour", [&] { wall->SetSpecularColor(0.25, 0.3, 0.4); }},
      {"edge colour", [&] { wall->SetEdgeColor(0.2, 0.3, 0.4); }},
      {"emissive factor", [&] { wall->SetEmissiveFactor(0.2, 1.0, 1.0); }},
      {"coat colour", [&] { wall->SetCoatColor(1.0, 0.3, 1.0); }},
      {"edge tint", [&] { wall->SetEdgeTint(1.0, 1.0, 0.4); }},
      {"ambient", [&] { wall->SetAmbient(0.1); }},
      {"diffuse", [&] { wall->SetDiffuse(0.9); }},
      {"specular", [&] { wall->SetSpecular(0.2); }},
      {"power", [&] { wall->SetSpecularPower(3.0); }},
      {"metal", [&] { wall->SetMetallic(0.25); }},
      {"roughness", [&] { wall->SetRoughness(0.3); }},
      {"index", [&] { wall->SetBaseIOR(1.6); }},
      {"coat", [&] { wall->SetCoatStrength(0.2); }},
      {"coat's index", [&] { wall->SetCoatIOR(1.7); }},
      {"coat's roughness", [&] { wall->SetCoatRoughness(0.4); }},
      {"normal scale", [&] { wall->SetNormalScale(0.5); }},
      {"occlusion", [&] { wall->SetOcclusionStrength(0.5); }},
      {"anisotropy", [&] { wall->SetAnisotropy(0.5); }},
      {"its turn", [&] { wall->SetAnisotropyRotation(0.5); }},
      {"line width", [&] { wall->SetLineWidth(2.0f); }},
      {"point size", [&] { wall->SetPointSize(2.0f); }},
      {"edges", [&] { wall->EdgeVisibilityOn(); }},
      {"no edges", [&] { wall->EdgeVisibilityOff(); }},
      {"vertices", [&] { wall->VertexVisibilityOn(); }},
      {"no vertices", [&] { wall->VertexVisibilityOff(); }},
      {"back faces", [&] { wall->BackfaceCullingOn(); }},
      {"both faces", [&] { wall->BackfaceCullingOff(); }},
      {"interpolation", [&] { wall->SetInterpolationToFlat(); }},
      {"lines", [&] { wall->SetRepresentationToWireframe(); }},
      {"surface", [&] { wall->SetRepresentationToSurface(); }},
      {"floor's colour", [&] { floor->SetColor(0.9, 1.0, 1.0); }, false, true},
      {"floor's roughness", [&] { floor->SetRoughness(0.1); }, false, true},
      {"floor hidden", [&] { room.floor->VisibilityOff(); }, false, true},
      {"hidden floor's colour", [&] { floor->SetColor(0.8, 1.0, 1.0); }, false, false},
      {"floor shown", [&] { room.floor->VisibilityOn(); }, false, true},
      {"wall hidden", [&] { room.others[1]->VisibilityOff(); }},
      {"hidden wall's colour", [&] { room.others[1]->GetProperty()->SetColor(0.1, 0.9, 0.1); }, false, false},
      {"wall shown", [&] { room.others[1]->VisibilityOn(); }},
      {"moved", [&] { room.others[0]->SetPosition(0.01, 0.0, 0.0); }},
      {"turned", [&] { room.others[0]->RotateX(1.0); }},
      {"data", [&] { input->GetInput()->Modified(); }},
      {"mapper", [&] { input->SetScalarVisibility(false); }},
      {"source", [&] { input->SetInputConnection(sphere->GetOutputPort()); }},
      {"source's value", [&] { sphere->SetRadius(0.2); }},
      {"texture", [&] { room.others[3]->SetTexture(texture); }},
      {"texture's value", [&] { texture->InterpolateOn(); }},
      {"no texture", [&] { room.others[3]->SetTexture(nullptr); }},
      {"intensity", [&] { lamp->SetIntensity(0.4); }},
      {"cone", [&] { lamp->SetConeAngle(130.0); }},
      {"exponent", [&] { lamp->SetExponent(1.5); }},
      {"lamp's colour", [&] { lamp->SetDiffuseColor(1.0, 0.9, 0.8); }},
      {"attenuation", [&] { lamp->SetAttenuationValues(1.0, 0.1, 0.0); }},
      {"lamp moved", [&] { lamp->SetPosition(0.1, 0.2, 0.4); }},
      {"lamp turned", [&] { lamp->SetFocalPoint(0.0, 0.1, 0.0); }},
      {"far", [&] { lamp->PositionalOff(); }},
      {"at the camera", [&] { lamp->SetLightTypeToHeadlight(); }},
      {"moved with the camera", [&] { lamp->SetPosition(0.0, 0.0, 2.0); }, false, false},
      {"off", [&] { lamp->SwitchOff(); }},
      {"intensity of what is off", [&] { lamp->SetIntensity(0.7); }, false, false},
      {"background", [&] { renderer->SetBackground(0.1, 0.2, 0.3); }},
      {"camera", [&] { camera->SetPosition(0.1, 0.0, 1.9); }, false, true},
      {"camera's angle", [&] { camera->SetViewAngle(61.0); }, false, true},
      {"camera's distances", [&] { camera->SetClippingRange(0.02, 30.0); }, false, false},
      {"size", [&] { room.window->SetSize(170, 160); }, false, true},
      {"exposure", [&] { probes.setExposure(1.5); }},
      {"emission", [&] { probes.setEmission(true); }},
      {"scattering", [&] { probes.setEnergy(Energy::Multiple); }},
      {"tone without VTK's power", [&] { probes.setTone(Tone::None); }},
      {"another curve", [&] { probes.setTone(Tone::Aces); }, false, true},
      {"probe's intensity", [&] { set([](Probe& p) { p.intensity = 0.5; }); }, false, true},
      {"probe's box", [&] { set([](Probe& p) { p.box.max.z = 2.5; }); }, false, true},
      {"technique", [&] { set([](Probe& p) { p.technique = "infinite"; }); }, false, true},
      {"origin", [&] { set([](Probe& p) { p.origin.x = 0.2; }); }},
      {"faces", [&] { set([](Probe& p) { p.faceSize = 32; }); }},
      {"samples", [&] { set([](Probe& p) { p.samplesPerPixel = 4; }); }},
      {"near", [&] { set([](Probe& p) { p.nearDistance = 0.02; }); }},
      {"far", [&] { set([](Probe& p) { p.farDistance = 70.0; }); }},
      {"clear", [&] { set([](Probe& p) { p.clear = glm::vec3(0.1f, 0.2f, 0.3f); }); }},
      {"sky", [&] { probes.setSky(SkyColor{glm::vec3(0.3f, 0.2f, 0.1f)}); }},
      {"background under a sky", [&] { renderer->SetBackground(0.3, 0.2, 0.3); }, false, false},
      {"no sky", [&] { probes.clearSky(); }},
      {"one unseen", [&] { probes.addActor(room.others[4], false); }, true, false},
      {"one removed", [&] { probes.removeActor(room.others[4]); }, false, true},
      {"none removed", [&] { probes.removeActor(room.others[4]); }, false, false},
      {"one added", [&] { probes.addActor(room.others[4]); }},
  };
  for (const Change& change : changes) {
    ASSERT_FALSE(probes.stale()) << "before: " << change.what;
    const std::uint64_t before = probes.pictures();
    change.make();
    EXPECT_EQ(probes.stale(), change.stale) << change.what;
    EXPECT_TRUE(probes.update()) << change.what << ": " << probes.error();
    room.window->Render();
    EXPECT_EQ(probes.pictures() - before, change.picture ? 1u : 0u) << change.what;
    room.window->Render();
    EXPECT_EQ(probes.pictures() - before, change.picture ? 1u : 0u) << "again: " << change.what;
  }
  EXPECT_EQ(probes.error(), "");
}

/// Linear light of what VTK shows as `shown`.
double linearOf(double shown) {
  return std::pow(shown, 2.2);
}

void expectTexel(const CubeMap& map, int face, int column, int row, const Point& shown, const std::string& what) {
  const glm::vec4 texel = map.texel(0, face, column, row);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(texel[c], linearOf(shown[static_cast<std::size_t>(c)]), 2e-3)
        << what << ": face " << face << ", column " << column << ", row " << row << ", channel " << c;
  }
}

/// Of a face's texel by table 8.19 of OpenGL 4.6.
glm::dvec3 directionOf(int face, int column, int row, int size) {
  const double s = (2.0 * column + 1.0) / size - 1.0, t = (2.0 * row + 1.0) / size - 1.0;
  switch (face) {
    case 0:
      return {1.0, -t, -s};
    case 1:
      return {-1.0, -t, s};
    case 2:
      return {s, 1.0, t};
    case 3:
      return {s, -1.0, -t};
    case 4:
      return {s, -t, 1.0};
    default:
      return {-s, -t, -1.0};
  }
}

TEST(ActorChanges, MapsHoldTheWallsAndTheirDistancesTexelByTexel) {
  const Room room;
  makeUnlit(room.floor, 0.9, 0.6, 0.1);
  ActorProbes probes(room.renderer);
  Probe probe = smallProbe(room);
  probe.origin = {0.7, -0.35, -0.6};
  probes.addProbe(probe);
  room.addAll(probes);
  probes.addActor(room.floor, true);
  ASSERT_TRUE(probes.capture()) << probes.error();
  ASSERT_NE(probes.maps(0), nullptr);
  const BakedMaps maps = readBackAsShown(*probes.maps(0));
  ASSERT_EQ(maps.radiance.faceSize(), 16);
  EXPECT_EQ(maps.capturedAt, probe.origin);
  const std::array<std::array<Point, 2>, 3> colors = {
      {{{{1, 0, 0}, {0, 1, 0}}}, {{{0.9, 0.6, 0.1}, {1, 1, 1}}}, {{{0.5, 0.5, 0.5}, {0, 0, 1}}}}};
  const glm::dvec3 half(2.0, 1.0, 2.0);
  int compared = 0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const glm::dvec3 d = glm::normalize(directionOf(face, column, row, 16));
        std::array<double, 3> along{};
        for (int axis = 0; axis < 3; ++axis) {
          along[static_cast<std::size_t>(axis)] =
              d[axis] == 0.0 ? 1e9 : ((d[axis] > 0.0 ? half[axis] : -half[axis]) - probe.origin[axis]) / d[axis];
        }
        const std::size_t axis = static_cast<std::size_t>(std::min_element(along.begin(), along.end()) - along.begin());
        std::array<double, 3> sorted = along;
        std::sort(sorted.begin(), sorted.end());
        if (sorted[1] < 1.15 * sorted[0]) continue;  // beside an edge
        expectTexel(maps.radiance, face, column, row, colors[axis][d[static_cast<int>(axis)] > 0.0 ? 1 : 0], "wall");
        EXPECT_NEAR(maps.distance.texel(0, face, column, row).x, sorted[0], 0.02 * sorted[0]) << face;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

/// A square of magenta across +x at that distance from the probe's origin, wider than the face.
vtkSmartPointer<vtkActor> screen(const glm::dvec3& origin, double distance) {
  const double x = origin.x + distance, y = origin.y, z = origin.z, r = 1.5 * distance;
  const auto actor = plane({x, y - r, z - r}, {x, y + r, z - r}, {x, y - r, z + r});
  makeUnlit(actor, 1.0, 0.0, 1.0);
  return actor;
}

TEST(ActorChanges, CapturesBeginAtAShareOfTheBoxAndEndBehindEverything) {
  const Room room;
  ActorProbes probes(room.renderer);
  Probe probe = smallProbe(room);
  probe.origin = {0.3, -0.2, 0.1};
  room.addAll(probes);
  probes.addProbe(probe);
  constexpr Point kScreen = {1.0, 0.0, 1.0}, kWall = {0.0, 1.0, 0.0};
  const auto expectSeen = [&](double distance, bool seen, const std::string& what) {
    const auto actor = screen(probes.probes()[0].origin, distance);
    room.renderer->AddActor(actor);
    probes.addActor(actor);
    ASSERT_TRUE(probes.update()) << probes.error();
    const BakedMaps maps = readBackAsShown(*probes.maps(0));
    expectTexel(maps.radiance, 0, 7, 8, seen ? kScreen : kWall, what);
    probes.removeActor(actor);
    room.renderer->RemoveActor(actor);
  };
  // 0.0025 of half the shortest side: 1.
  expectSeen(0.0023, false, "nearer");
  expectSeen(0.0027, true, "farther");
  const auto resize = [&](const glm::dvec3& half) {
    Probe next = probes.probes()[0];
    next.box = {-half, half};
    probes.setProbe(0, next);
  };
  // A box up to eight times as small keeps the distance it had.
  resize({0.15, 1.0, 2.0});
  expectSeen(0.0023, false, "six times as thin");
  resize({2.0, 1.0, 0.1});
  expectSeen(0.00023, false, "ten times as thin, nearer");
  expectSeen(0.00027, true, "ten times as thin, farther");
  resize({2.0, 0.7, 1.4});
  expectSeen(0.00023, false, "seven times as thick");
  expectSeen(0.0016, true, "seven times as thick");
  resize({2.0, 0.9, 1.4});
  expectSeen(0.0021, false, "nine times as thick, nearer");
  expectSeen(0.0024, true, "nine times as thick, farther");
  // As set, nothing is derived.
  Probe fixed = probes.probes()[0];
  fixed.nearDistance = 0.05;
  probes.setProbe(0, fixed);
  expectSeen(0.04, false, "nearer than it is set");
  expectSeen(0.06, true, "farther than it is set");
  fixed.farDistance = 1.2;
  probes.setProbe(0, fixed);
  {
    const auto actor = screen(fixed.origin, 1.3);
    probes.addActor(actor);
    ASSERT_TRUE(probes.update());
    expectTexel(readBackAsShown(*probes.maps(0)).radiance, 0, 7, 8, {0.0, 0.0, 0.0}, "farther than the end");
    probes.removeActor(actor);
  }
}

// The end of a capture is measured from its origin, wherever the room lies.
TEST(ActorChanges, CapturesReachTheFarthestActorFromEachSide) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(smallProbe(room));
  for (const double side : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      Probe probe = smallProbe(room);
      // The origin is 60 away from 0, where what is seen from there ends.
      glm::dvec3 center(0.0);
      center[axis] = 60.0 * side;
      probe.box = {center - 0.05, center + 0.05};
      probe.origin = center;
      probes.setProbe(0, probe);
      Point a{}, b{}, c{};
      const auto first = static_cast<std::size_t>((axis + 1) % 3), second = static_cast<std::size_t>((axis + 2) % 3);
      a[first] = b[first] = a[second] = c[second] = -20.0;
      b[second] = c[first] = 20.0;
      c[axis] = 50.0 * side;  // it leans: one end is 60 away, the other 10, the middle 35
      const auto far = plane(a, b, c);
      makeUnlit(far, 0.4, 0.8, 0.6);
      probes.addActor(far);
      ASSERT_TRUE(probes.capture()) << probes.error();
      // Behind the origin of the side.
      const int face = 2 * axis + (side > 0.0 ? 1 : 0);
      expectTexel(readBackAsShown(*probes.maps(0)).radiance, face, 8, 8, {0.4, 0.8, 0.6},
                  "axis " + std::to_string(axis) + (side > 0.0 ? " from above" : " from below"));
      probes.removeActor(far);
    }
  }
}

TEST(ActorChanges, AProbeLightsWhatLiesWithinItsInfluenceLessItsBlending) {
  struct Case {
    const char* what;
    glm::dvec3 middle;  ///< of a square across y of half a unit's radius
    BlendDistance blend;
    double turn;
    bool physical, lit;
  };
  const BlendDistance none{glm::dvec3(0.0), glm::dvec3(0.0)};
  const BlendDistance low{glm::dvec3(0.0, 0.4, 0.0), glm::dvec3(0.0)}, high{glm::dvec3(0.0), glm::dvec3(0.0, 0.4, 0.0)};
  const BlendDistance both{glm::dvec3(0.4), glm::dvec3(0.4)};
  // The influence: -3 to 1, -1 to 2, -5 to 7.
  const std::vector<Case> cases = {
      {"in the middle", {0, 0, 0}, none, 0, true, true},
      {"in the middle, unlit", {0, 0, 0}, none, 0, false, false},
      {"in a face", {0, -1, 0}, none, 0, true, true},
      {"in the other face", {0, 2, 0}, none, 0, true, true},
      {"below", {0, -1.001, 0}, none, 0, true, false},
      {"above", {0, 2.001, 0}, none, 0, true, false},
      {"in a face that blends", {0, -1, 0}, both, 0, true, false},
      {"above a face that blends", {0, -0.999, 0}, both, 0, true, true},
      {"in the other that blends", {0, 2, 0}, both, 0, true, false},
      {"below the other", {0, 1.999, 0}, both, 0, true, true},
      {"in a face, and only it blends", {0, -1, 0}, low, 0, true, true},
      {"in a face, and only the other blends", {0, 2, 0}, high, 0, true, true},
      {"touching at -x", {-3.499, 0, 0}, none, 0, true, true},
      {"off at -x", {-3.502, 0, 0}, none, 0, true, false},
      {"touching at +x", {1.499, 0, 0}, none, 0, true, true},
      {"off at +x", {1.502, 0, 0}, none, 0, true, false},
      {"touching at -z", {0, 0, -5.499}, none, 0, true, true},
      {"off at -z", {0, 0, -5.503}, none, 0, true, false},
      {"touching at +z", {0, 0, 7.499}, none, 0, true, true},
      {"off at +z", {0, 0, 7.503}, none, 0, true, false},
      // Turned by 90 degrees about y, around the middle of the projection box (0, 0, 0): x of the box along -z.
      {"turned, at -x of the box", {0, 0, 3.4}, none, 90, true, true},
      {"turned, off at -x of the box", {0, 0, 3.6}, none, 90, true, false},
      {"turned, at +z of the box", {7.4, 0, 0}, none, 90, true, true},
      {"turned, off at +z of the box", {7.6, 0, 0}, none, 90, true, false},
  };
  const Room room;
  room.renderer->RemoveAllViewProps();
  ActorProbes probes(room.renderer);
  probes.addProbe(smallProbe(room));
  for (const Case& c : cases) {
    for (const bool ofAssembly : {false, true}) {
      Probe probe = smallProbe(room);
      probe.influence = Box{{-3, -1, -5}, {1, 2, 7}};
      probe.blendDistance = c.blend;
      probe.rotationDegrees.y = c.turn;
      const auto square = plane({-0.5, 0, -0.5}, {0.5, 0, -0.5}, {-0.5, 0, 0.5});
      c.physical ? makeMirror(square) : makeUnlit(square, 1, 1, 1);
      vtkNew<vtkAssembly> assembly;
      if (ofAssembly) {
        assembly->AddPart(square);
        assembly->SetPosition(c.middle.x, c.middle.y, c.middle.z);
        room.renderer->AddActor(assembly);
      } else {
        square->SetPosition(c.middle.x, c.middle.y, c.middle.z);
        room.renderer->AddActor(square);
      }
      probes.setProbe(0, probe);
      probes.addActor(square);
      ASSERT_TRUE(probes.capture()) << probes.error();
      EXPECT_EQ(probes.remarks().size(), c.lit ? 0u : 1u) << c.what << (ofAssembly ? ", a part" : "");
      probes.removeActor(square);
      room.renderer->RemoveAllViewProps();
    }
  }
}

TEST(ActorChanges, ARendererThatIsDrawnInAnotherWayIsNotRefined) {
  const Room room;
  ActorProbes probes(room.renderer);
  probes.addProbe(smallProbe(room));
  room.addAll(probes);
  probes.setRefinement({16, 0.0, 0.0});
  vtkRenderer* renderer = room.renderer;
  vtkNew<vtkRenderStepsPass> pass;
  const std::vector<std::pair<std::string, std::function<void(bool)>>> ways = {
      {"a render pass of its own", [&](bool on) { renderer->SetPass(on ? pass.Get() : nullptr); }},
      {"ambient occlusion (UseSSAO)", [&](bool on) { renderer->SetUseSSAO(on); }},
      {"smoothed edges (UseFXAA)", [&](bool on) { renderer->SetUseFXAA(on); }},
      {"shadows (UseShadows)", [&](bool on) { renderer->SetUseShadows(on ? 1 : 0); }},
      {"", [&](bool on) { renderer->SetUseDepthPeeling(on ? 1 : 0); }},  // of nothing translucent
      {"peeled layers (UseDepthPeeling)",
       [&](bool on) {
         renderer->SetUseDepthPeeling(on ? 1 : 0);
         room.others[1]->GetProperty()->SetOpacity(on ? 0.5 : 1.0);
       }},
  };
  for (const auto& [what, set] : ways) {
    EXPECT_EQ(probes.refusedRefinement(), "") << what;
    set(true);
    const std::string wanted = what.empty() ? ""
                                            : "the picture is not refined: its renderer has " + what +
                                                  ", which the averaged frames would go without";
    EXPECT_EQ(probes.refusedRefinement(), wanted);
    if (!what.empty()) {
      EXPECT_FALSE(probes.refineStep());
      EXPECT_FALSE(probes.refining());
    }
    set(false);
  }
  EXPECT_TRUE(probes.refineStep()) << "a picture that was not seen before is the techniques' own";
  EXPECT_TRUE(probes.refineStep());
  EXPECT_TRUE(probes.refining());
}

}  // namespace
