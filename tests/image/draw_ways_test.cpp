// The room of six coloured walls and its mirror ball, drawn in every way VTK has: whatever the way, each pixel of the
// ball shows the wall its reflected ray meets, from all six sides. Walls and quadrants are worked out here by hand.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkVersionMacros.h>

#include <cmath>
#include <functional>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/surface/vtkProbeActor.h"
#include "tests/support/scene_picture.h"
#include "tests/support/shown_light.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kSize = 201;
constexpr double kBallRadius = 0.5, kHalfRoom = 2.0;
const glm::vec3 kWallColors[6] = {{0.80f, 0.08f, 0.06f}, {0.06f, 0.62f, 0.66f}, {0.10f, 0.62f, 0.10f},
                                  {0.66f, 0.08f, 0.62f}, {0.08f, 0.16f, 0.85f}, {0.85f, 0.70f, 0.06f}};

/// What a ray from inside the room sees; nothing near the borders of quadrants and the white marks.
std::optional<glm::vec3> wallSeen(const glm::dvec3& from, const glm::dvec3& along) {
  double nearest = 1e300;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0.0) continue;
    const double t = ((along[axis] > 0.0 ? kHalfRoom : -kHalfRoom) - from[axis]) / along[axis];
    if (t >= nearest) continue;
    nearest = t;
    face = 2 * axis + (along[axis] > 0.0 ? 0 : 1);
  }
  const glm::dvec3 hit = (from + nearest * along) / kHalfRoom;
  const glm::dvec3 middle(shading::cubeDirection(face, 0.0f, 0.0f));
  const double s = glm::dot(hit, glm::dvec3(shading::cubeDirection(face, 1.0f, 0.0f)) - middle);
  const double t = glm::dot(hit, glm::dvec3(shading::cubeDirection(face, 0.0f, 1.0f)) - middle);
  if (std::abs(s) < 0.15 || std::abs(t) < 0.15 || std::abs(s) > 0.85 || std::abs(t) > 0.85) return std::nullopt;
  if (s < -0.55 && t < -0.55) return std::nullopt;  // around the mark
  return kWallColors[face] * (t < 0 ? (s < 0 ? 1.0f : 0.65f) : (s < 0 ? 0.4f : 0.2f));
}

Camera sideCamera(int from, bool parallel = false) {
  Camera camera;
  camera.position = 1.9 * glm::dvec3(shading::cubeDirection(from, 0.0f, 0.0f));
  camera.target = glm::dvec3(0.0);
  camera.up = glm::abs(camera.position.y) > 1.0 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  camera.verticalFovDegrees = 35.0;
  camera.parallelHeight = parallel ? 1.1 : 0.0;
  return camera;
}

/// What a pixel should show: the ball's point there and the walls reflected and behind it.
struct Seen {
  glm::dvec3 point, normal;
  glm::vec3 reflected, behind;
  bool behindKnown = false;
};

std::optional<Seen> seenAt(const Camera& camera, int x, int y) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const double half = camera.parallelHeight > 0.0 ? 0.5 * camera.parallelHeight
                                                  : std::tan(glm::radians(0.5 * camera.verticalFovDegrees));
  const glm::dvec3 across = half * ((2.0 * (x + 0.5) / kSize - 1.0) * right + (1.0 - 2.0 * (y + 0.5) / kSize) * up);
  const bool parallel = camera.parallelHeight > 0.0;
  const glm::dvec3 eye = parallel ? camera.position + across : camera.position;
  const glm::dvec3 along = parallel ? forward : glm::normalize(forward + across);
  const double b = glm::dot(eye, along), c = glm::dot(eye, eye) - kBallRadius * kBallRadius;
  if (b * b - c <= 0.0) return std::nullopt;
  Seen seen;
  seen.point = eye + (-b - std::sqrt(b * b - c)) * along;
  seen.normal = glm::normalize(seen.point);
  if (glm::dot(seen.normal, along) > -0.35) return std::nullopt;  // where facets and rounding show
  const auto reflected = wallSeen(seen.point, glm::reflect(along, seen.normal));
  if (!reflected) return std::nullopt;
  seen.reflected = *reflected;
  const auto behind = wallSeen(seen.point, along);
  seen.behindKnown = behind.has_value();
  seen.behind = behind.value_or(glm::vec3(0.0f));
  return seen;
}

glm::vec3 encoded(const glm::vec3& linear) {
  glm::vec3 shown;
  for (int c = 0; c < 3; ++c) shown[c] = static_cast<float>(shownLight(linear[c]));
  return shown;
}

glm::vec3 decoded(const glm::vec3& shown) {
  glm::vec3 linear;
  for (int c = 0; c < 3; ++c) linear[c] = static_cast<float>(lightShown(shown[c]));
  return linear;
}

glm::vec3 pixelOf(const ImageRgba8& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[4 * static_cast<std::size_t>(y * image.width + x)];
  return glm::vec3(p[0], p[1], p[2]) / 255.0f;
}

bool near(const glm::vec3& a, const glm::vec3& b, float within = 0.03f) {
  const glm::vec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z}) <= within;
}

class DrawWays : public ::testing::Test {
 protected:
  DrawWays() = default;

  void open(int multiSamples = 0, int width = kSize) {
    picture = std::make_unique<ScenePicture>(
        loadSceneFile(std::string(BOXPROBE_DATA_DIR) + "/scenes/six-faces.boxprobe.json"), width, kSize, multiSamples);
    picture->show(sideCamera(0));
  }
  /// The ball's actor: the only one that does not reach the walls.
  vtkActor* ball() {
    vtkActorCollection* actors = picture->renderer->renderer()->GetActors();
    actors->InitTraversal();
    for (vtkActor* actor = actors->GetNextActor(); actor != nullptr; actor = actors->GetNextActor()) {
      if (actor->GetBounds()[1] < 1.0 && actor->GetBounds()[0] > -1.0) return actor;
    }
    throw std::runtime_error("no ball");
  }
  vtkMapper* ballMapper() { return ball()->GetMapper(); }
  vtkProperty* look() { return ball()->GetProperty(); }

  using Judge = std::function<bool(const glm::vec3& pixel, const Seen& seen)>;
  struct Count {
    int compared = 0, right = 0;
    double share() const { return compared > 0 ? static_cast<double>(right) / compared : 0.0; }
  };
  Count compare(const ImageRgba8& image, const Camera& camera, const Judge& judge, int left = 0) const {
    Count count;
    for (int y = 1; y < kSize; y += 3) {
      for (int x = 1; x < kSize; x += 3) {
        const auto seen = seenAt(camera, x, y);
        if (!seen) continue;
        ++count.compared;
        count.right += judge(pixelOf(image, left + x, y), *seen) ? 1 : 0;
      }
    }
    return count;
  }
  /// Every pixel of the ball, from six sides. `least`: the share that has to be right, where something is drawn on top.
  void expectReflections(const Judge& judge, bool parallel = false, double least = 1.0) {
    for (int from = 0; from < 6; ++from) {
      const Camera camera = sideCamera(from, parallel);
      picture->renderer->applyCamera(camera);
      const ImageRgba8 image = picture->display();
      keepPicture(image, std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                             std::to_string(from));
      const Count count = compare(image, camera, judge);
      EXPECT_GT(count.compared, 250) << "from " << from;
      EXPECT_GE(count.share(), least) << "from " << from << " of " << count.compared;
    }
    EXPECT_EQ(picture->renderer->error(), "");
  }
  static bool mirrors(const glm::vec3& pixel, const Seen& seen) { return near(pixel, encoded(seen.reflected)); }

  std::unique_ptr<ScenePicture> picture;
};

TEST_F(DrawWays, Opaque) {
  open();
  expectReflections(mirrors);
}

TEST_F(DrawWays, SeveralSamplesAPixel) {
  open(4);
  expectReflections(mirrors);
}

TEST_F(DrawWays, ParallelProjection) {
  open();
  expectReflections(mirrors, true);
}

TEST_F(DrawWays, PeelingLeavesOpaqueScenesAsTheyAre) {
  open();
  vtkRenderer* renderer = picture->renderer->renderer();
  picture->window->SetAlphaBitPlanes(1);
  for (int from = 0; from < 6; ++from) {
    picture->renderer->applyCamera(sideCamera(from));
    renderer->UseDepthPeelingOff();
    const ImageRgba8 off = picture->display();
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(8);
    EXPECT_EQ(picture->display().pixels, off.pixels) << "from " << from;
  }
}

// A pane of glass that mirrors: half the reflection over half of the wall behind, in display colours, as VTK blends.
TEST_F(DrawWays, TranslucentWithAndWithoutPeeling) {
  for (const bool peeling : {false, true}) {
    open();
    if (peeling) {
      picture->window->SetAlphaBitPlanes(1);
      picture->renderer->renderer()->UseDepthPeelingOn();
      picture->renderer->renderer()->SetMaximumNumberOfPeels(8);
    }
    look()->SetOpacity(0.5);
    ball()->ForceOpaqueOff();
    ball()->ForceTranslucentOn();
    expectReflections([](const glm::vec3& pixel, const Seen& seen) {
      return !seen.behindKnown || near(pixel, 0.5f * (encoded(seen.reflected) + encoded(seen.behind)));
    });
  }
}

// A coat adds a little of the same reflection to it: the hue stays.
TEST_F(DrawWays, ClearCoat) {
  open();
  look()->SetCoatStrength(1.0);
  look()->SetCoatRoughness(0.0);
  // What was drawn lies up to half a step of 8 bits and a twentieth above what the pixel says; a step is 1.1 % of the
  // light here.
  constexpr float kAbove = (0.5f + 0.05f) / 255.0f;
  expectReflections([&](const glm::vec3& pixel, const Seen& seen) {
    const auto gainOf = [&](const glm::vec3& light) {
      return glm::dot(light, seen.reflected) / glm::dot(seen.reflected, seen.reflected);
    };
    const glm::vec3 linear = decoded(pixel), most = decoded(pixel + kAbove);
    const float gain = gainOf(linear);
    return gainOf(most) > 0.99f && gain < 1.25f && near(linear, gain * seen.reflected, 0.02f);
  });
}

TEST_F(DrawWays, Anisotropy) {
  open();
  auto* data = vtkPolyData::SafeDownCast(ballMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkFloatArray> tangents;
  tangents->SetName("Tangents");
  tangents->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const glm::dvec3 n(data->GetPoint(i)[0], data->GetPoint(i)[1], data->GetPoint(i)[2]);
    const glm::dvec3 t = glm::cross(glm::dvec3(0, 1, 0), n) + glm::dvec3(1e-9, 0, 0);
    tangents->InsertNextTuple3(t.x, t.y, t.z);
  }
  data->GetPointData()->SetTangents(tangents);
  look()->SetAnisotropy(0.8);
  expectReflections(mirrors);
}

TEST_F(DrawWays, SeveralRenderersInOneWindow) {
  open(0, 2 * kSize);
  picture->renderer->renderer()->SetViewport(0.0, 0.0, 0.5, 1.0);
  // Beside it one of VTK's own, over that one more of ours.
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> plain;
  plain->SetViewport(0.5, 0.5, 1.0, 1.0);
  plain->AddActor(actor);
  picture->window->AddRenderer(plain);
  for (int from = 0; from < 6; ++from) {
    const Camera camera = sideCamera(from);
    picture->renderer->applyCamera(camera);
    const ImageRgba8 image = picture->display();
    const Count count = compare(image, camera, mirrors);
    EXPECT_GT(count.compared, 250);
    EXPECT_EQ(count.share(), 1.0) << "from " << from;
  }
  picture->window->RemoveRenderer(plain);

  SceneRenderer second(picture->window);
  second.renderer()->SetViewport(0.5, 0.0, 1.0, 1.0);
  second.setModels({std::make_shared<Model>(loadModelFile(picture->scene.models[0].file))});
  second.sync(picture->scene, Changes::all());
  second.finishWork();
  for (int from = 0; from < 6; ++from) {
    const Camera left = sideCamera(from), right = sideCamera((from + 2) % 6);
    picture->renderer->applyCamera(left);
    second.applyCamera(right);
    const ImageRgba8 image = picture->display();
    EXPECT_EQ(compare(image, left, mirrors).share(), 1.0) << "from " << from;
    EXPECT_EQ(compare(image, right, mirrors, kSize).share(), 1.0) << "from " << from;
  }
  EXPECT_EQ(second.error(), "");
  second.releaseGraphics();
}

TEST_F(DrawWays, HiddenLines) {
  open();
  picture->renderer->renderer()->UseHiddenLineRemovalOn();
  vtkActor* mirror = ball();
  vtkActorCollection* actors = picture->renderer->renderer()->GetActors();
  actors->InitTraversal();
  for (vtkActor* actor = actors->GetNextActor(); actor != nullptr; actor = actors->GetNextActor()) {
    if (actor != mirror) actor->GetProperty()->SetRepresentationToWireframe();
  }
  expectReflections(mirrors);
}

// What lies on the lines has the reflection of the ball's surface there; between them the walls show.
TEST_F(DrawWays, Wireframe) {
  open();
  look()->SetRepresentationToWireframe();
  for (int from = 0; from < 6; ++from) {
    const Camera camera = sideCamera(from);
    picture->renderer->applyCamera(camera);
    const ImageRgba8 image = picture->display();
    int lines = 0, right = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const auto seen = seenAt(camera, x, y);
        if (!seen || !seen->behindKnown || near(encoded(seen->reflected), encoded(seen->behind), 0.1f)) continue;
        const glm::vec3 pixel = pixelOf(image, x, y);
        if (near(pixel, encoded(seen->behind))) continue;
        ++lines;
        right += mirrors(pixel, *seen) ? 1 : 0;
      }
    }
    EXPECT_GT(lines, 300) << "from " << from;
    // Lines of the ball's far side are seen through the near one's gaps, where they reflect other walls.
    EXPECT_GT(right, lines / 3) << "from " << from;
  }
}

TEST_F(DrawWays, EdgesAreDrawnOverTheReflection) {
  open();
  look()->EdgeVisibilityOn();
  look()->SetEdgeColor(1.0, 1.0, 1.0);
  int onEdges = 0;
  expectReflections([&](const glm::vec3& pixel, const Seen& seen) {
    // Smooth lines: a mixture of reflection and white.
    const glm::vec3 mirror = encoded(seen.reflected), toWhite = 1.0f - mirror;
    const float share = glm::dot(pixel - mirror, toWhite) / glm::dot(toWhite, toWhite);
    onEdges += share > 0.8f ? 1 : 0;
    return share > -0.1f && share < 1.1f && near(pixel, mirror + share * toWhite);
  });
  EXPECT_GT(onEdges, 100);
}

// VTK keeps an account of what it has switched on; some builds check it at every call and print each difference.
TEST_F(DrawWays, VtksAccountOfItsStateStaysRight) {
  open();
  expectReflections(mirrors);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(picture->renderer->renderer()->GetRenderWindow());
  ASSERT_NE(window, nullptr);
  window->MakeCurrent();
  for (const GLenum what : {GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE})
    EXPECT_EQ(window->GetState()->GetEnumState(what), glIsEnabled(what) == GL_TRUE) << what;
}

// Up to 9.3 VTK draws no vertices over a lit surface, with its own shading neither; what it does draw stays right. 9.6
// draws them, three pixels wide: they cover up to an eighth of the ball.
TEST_F(DrawWays, VertexVisibility) {
  constexpr bool kDrawn = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0);
  open();
  look()->VertexVisibilityOn();
  look()->SetVertexColor(1.0, 0.0, 0.0);
  look()->SetPointSize(3.0f);
  expectReflections(mirrors, false, kDrawn ? 0.85 : 1.0);
}

TEST_F(DrawWays, ClippingPlanesCutReflectingSurfaces) {
  open();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.6, 0.64, 0.48);
  ballMapper()->AddClippingPlane(plane);
  const glm::dvec3 n(0.6, 0.64, 0.48);
  int kept = 0, cut = 0;
  expectReflections([&](const glm::vec3& pixel, const Seen& seen) {
    const double side = glm::dot(seen.point, n);
    if (std::abs(side) < 0.02) return true;
    ++(side > 0.0 ? kept : cut);
    if (side > 0.0) return mirrors(pixel, seen);
    return !seen.behindKnown || near(pixel, encoded(seen.behind));
  });
  EXPECT_GT(kept, 500);
  EXPECT_GT(cut, 500);
}

// VTK's glyph mapper draws its copies with a mapper of its own that nothing can be put in place of: they have VTK's
// plain shading, and what has probes beside them stays as it is.
TEST_F(DrawWays, GlyphsBesideReflectingSurfaces) {
  open();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.5, -1.5, -1.5);
  points->InsertNextPoint(1.5, 1.5, 1.5);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.1);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(source->GetOutputPort());
  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(mapper);
  picture->renderer->renderer()->AddActor(glyphs);
  expectReflections(mirrors, false, 0.95);
  picture->renderer->renderer()->RemoveActor(glyphs);
}

// VTK 9.1 never lets go of a pass whose keys are thrown away with it, and a pass holds its surface's textures.
TEST(DrawnModels, TakeTheirTexturesWithThem) {
  ScenePicture room = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  room.show(room.scene.cameras.front());
  room.display();
  GLuint handle = 0;
  vtkActorCollection* actors = room.renderer->renderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) {
    const auto* lit = vtkProbeActor::SafeDownCast(actor);
    if (lit == nullptr) continue;
    for (const SurfaceSlot& slot : lit->GetPass()->GetSurface()->slots) {
      if (slot.texture) handle = slot.texture->handle();
    }
  }
  room.window->MakeCurrent();
  ASSERT_NE(handle, 0u);
  ASSERT_TRUE(glIsTexture(handle));
  room.scene.models.clear();
  room.renderer->setModels({});
  room.renderer->sync(room.scene, Changes::all());
  room.window->MakeCurrent();
  EXPECT_FALSE(glIsTexture(handle));
}

}  // namespace
