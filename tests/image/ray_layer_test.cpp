// Projection rays in the picture: width, halo, hidden parts, colours; nothing of them where they do not belong.
#include "filters/vtk/rays/ray_layer.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/io/gltf/model_file.h"
#include "filters/vtk/rays/ray_arrays.h"
#include "filters/vtk/rays/ray_lines.h"
#include "filters/vtk/rays/ray_sources.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 400, kHeight = 300;

// A renderer with nothing in it but what a test puts there, looking along -z from (0, 0, 10).
class Bare : public testing::Test {
 protected:
  Bare() : window(makeWindow(kWidth, kHeight)) {
    window->AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 10);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewAngle(30);
    camera->SetClippingRange(0.1, 100);
  }
  void draw(const std::vector<RayLine>& rays, bool visible = true) {
    RayLines lines;
    for (const RayLine& ray : rays) lines.add(ray);
    vtkNew<vtkPolyData> data;
    lines.writeTo(data, {"room"});
    layer.setLegendVisible(false);
    layer.setRays(data);
    layer.setVisible(visible);
    window->Render();
    window->GetRGBACharPixelData(0, 0, kWidth - 1, kHeight - 1, 0, pixels);
  }
  // Rows from the bottom up.
  glm::ivec3 pixel(int x, int y) const {
    const unsigned char* p = pixels->GetPointer(4 * (static_cast<vtkIdType>(y) * kWidth + x));
    return {p[0], p[1], p[2]};
  }
  static bool isCore(const glm::ivec3& p) { return p.r > 200 && p.g > 110 && p.g < 190 && p.b < 90; }  // reflected ray
  static bool isHalo(const glm::ivec3& p) { return std::max({p.r, p.g, p.b}) < 110; }
  int coreOfColumn(int x) const {
    int count = 0;
    for (int y = 0; y < kHeight; ++y) count += isCore(pixel(x, y)) ? 1 : 0;
    return count;
  }

  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  RayLayer layer{renderer};
  vtkNew<vtkUnsignedCharArray> pixels;
};

RayLine reflected(const glm::dvec3& from, const glm::dvec3& to) {
  RayLine line;
  line.kind = RayKind::Reflected;
  line.from = from;
  line.to = to;
  return line;
}

TEST_F(Bare, AsWideFarAsNearAndInAHaloOnABrightWall) {
  layer.setLineWidth(4.0);
  renderer->SetBackground(1.0, 1.0, 1.0);
  // From close to the eye to ten times as far.
  draw({reflected({-0.9, -0.1, 7.0}, {12.0, 0.1, -25.0})});
  int columns = 0;
  for (int x = 40; x < 340; x += 20) {
    const int width = coreOfColumn(x);
    if (width == 0) continue;
    ++columns;
    EXPECT_GE(width, 3) << x;
    EXPECT_LE(width, 5) << x;
    int first = 0;
    while (!isCore(pixel(x, first))) ++first;
    // The halo's 1.75 pixels have a smooth edge on either side: one of the next three is dark all through.
    const auto halo = [&](int y) { return isHalo(pixel(x, y)); };
    EXPECT_TRUE(halo(first - 1) || halo(first - 2) || halo(first - 3)) << x;
    const int last = first + width - 1;
    EXPECT_TRUE(halo(last + 1) || halo(last + 2) || halo(last + 3)) << x;
  }
  EXPECT_GE(columns, 10);
  renderer->SetBackground(0.0, 0.0, 0.0);
  draw({reflected({-0.9, -0.1, 7.0}, {12.0, 0.1, -25.0})});
  EXPECT_GE(coreOfColumn(200), 3);
}

TEST_F(Bare, TheHiddenPartIsDashedNotLost) {
  vtkNew<vtkCubeSource> wall;
  wall->SetBounds(0.0, 3.0, -2.0, 2.0, 1.0, 1.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(wall->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.9, 0.9, 0.9);
  renderer->AddActor(actor);
  draw({reflected({-2.4, 0.0, 0.0}, {2.4, 0.0, 0.0})});
  const auto touched = [&](int x) {
    for (int y = kHeight / 2 - 1; y <= kHeight / 2; ++y) {
      const glm::ivec3 p = pixel(x, y);
      if (p.r - p.b > 40) return true;
    }
    return false;
  };
  int open = 0, hidden = 0;
  for (int x = 100; x < 180; ++x) open += touched(x) ? 1 : 0;
  for (int x = 220; x < 300; ++x) hidden += touched(x) ? 1 : 0;
  EXPECT_EQ(open, 80);
  EXPECT_GT(hidden, 30);
  EXPECT_LT(hidden, 60);
}

TEST_F(Bare, LinesThroughTheEyeAndBehindItAreCut) {
  draw({reflected({0.0, -0.2, 30.0}, {0.0, -0.2, -5.0}), reflected({1.0, 1.0, 12.0}, {5.0, 1.0, 40.0})});
  int core = 0;
  for (int x = 0; x < kWidth; ++x) core += coreOfColumn(x);
  EXPECT_GT(core, 20);
  EXPECT_LT(core, 1200);  // one line from the lower edge to the middle, nothing of the other
}

TEST_F(Bare, ALineThatIsCutLooksTheSameFromEitherEnd) {
  const glm::dvec3 behind(0.75, -0.5, 17.0), ahead(-1.125, 0.25, -5.0);
  std::array<std::vector<bool>, 2> core;
  for (const int way : {0, 1}) {
    draw({way == 0 ? reflected(behind, ahead) : reflected(ahead, behind)});
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) core[way].push_back(isCore(pixel(x, y)));
    }
  }
  int both = 0, one = 0;
  for (std::size_t i = 0; i < core[0].size(); ++i) {
    both += core[0][i] && core[1][i] ? 1 : 0;
    one += core[0][i] != core[1][i] ? 1 : 0;
  }
  EXPECT_GT(both, 20);
  EXPECT_LE(one, both / 3) << "more than its edges, which round otherwise";
}

TEST_F(Bare, OffIsNotThere) {
  draw({}, false);
  const int props = renderer->GetViewProps()->GetNumberOfItems();
  const std::vector<unsigned char> before(pixels->GetPointer(0), pixels->GetPointer(0) + 4 * kWidth * kHeight);
  draw({reflected({-1, 0, 0}, {1, 0, 0})});
  EXPECT_GT(renderer->GetViewProps()->GetNumberOfItems(), props);
  layer.setLegendVisible(true);
  window->Render();
  draw({reflected({-1, 0, 0}, {1, 0, 0})}, false);
  EXPECT_EQ(renderer->GetViewProps()->GetNumberOfItems(), props);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), pixels->GetPointer(0)));
  // What was set while it was off shows when it is on again.
  layer.setColoring(RayColoring::Probe);
  layer.setColoring(RayColoring::Kind);
  layer.setVisible(true);
  window->Render();
  window->GetRGBACharPixelData(0, 0, kWidth - 1, kHeight - 1, 0, pixels);
  EXPECT_GT(coreOfColumn(kWidth / 2), 0);
}

TEST_F(Bare, NumbersColourTheLinesOverTheirRange) {
  RayLine close = reflected({-1, 0.5, 0}, {1, 0.5, 0}), distant = reflected({-1, -0.5, 0}, {1, -0.5, 0});
  close.hitDistance = 0.0;
  distant.hitDistance = 8.0;
  RayLine none = reflected({-1, 0, 0}, {1, 0, 0});
  layer.setColoring(RayColoring::HitDistance);
  layer.setLineWidth(5.0);
  draw({close, distant, none});
  EXPECT_EQ(layer.range(), (RayRange{0.0, 8.0}));
  const auto at = [&](double y) {
    const int row = static_cast<int>(kHeight / 2 + y / (10.0 * std::tan(0.2617994)) * kHeight / 2);
    return pixel(kWidth / 2 - 20, row);
  };
  EXPECT_GT(at(0.5).b, at(0.5).r + 60);    // blue
  EXPECT_GT(at(-0.5).r, at(-0.5).b + 60);  // yellow
  EXPECT_NEAR(at(0.0).r, at(0.0).b, 2);    // grey: not defined
  layer.setColoring(RayColoring::HitDistance, RayRange{2.0, 4.0});
  EXPECT_EQ(layer.range(), (RayRange{2.0, 4.0}));
}

// The rays of a grid of pixels, or from one object, of a scene's main camera.
struct SceneRays {
  SceneRays(const std::string& name, int width, int height)
      : picture(ScenePicture::fromFile("scenes/" + name + ".boxprobe.json", width, height)) {}

  void start(const Camera& camera) {
    picture.show(camera);
    std::vector<std::shared_ptr<const Model>> models;
    for (const ModelFile& f : picture.scene.models) models.push_back(std::make_shared<Model>(loadModelFile(f.file)));
    sources = std::make_unique<RaySources>(models, picture.scene);
    layer = std::make_unique<RayLayer>(picture.renderer->renderer());
    filter->SetEye(camera.position.x, camera.position.y, camera.position.z);
    filter->SetProbes(picture.scene.probes);
    filter->SetSceneData(sources->triangles());
    filter->SetMaximumLength(8.0);
  }
  void show(const std::vector<RaySample>& samples) {
    filter->SetInputData(rayPoints(samples));
    filter->Update();
    layer->setRays(filter->GetOutput());
    layer->setVisible(true);
  }

  ScenePicture picture;
  std::unique_ptr<RaySources> sources;
  std::unique_ptr<RayLayer> layer;
  vtkNew<vtkProjectionRays> filter;
};

std::size_t differentPixels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    count += std::equal(a.begin() + static_cast<long>(i), a.begin() + static_cast<long>(i) + 4,
                        b.begin() + static_cast<long>(i))
                 ? 0
                 : 1;
  }
  return count;
}

TEST(RaysInAScene, InTheWindowOnly) {
  SceneRays rays("room", 640, 360);
  rays.start(cameraNamed(rays.picture.scene, "main"));
  const ImageRgba8 before = rays.picture.display();
  const ImageRgbaF linearBefore = rays.picture.linear(1);
  rays.show(rays.sources->over("floor", 24));
  const ImageRgba8 with = rays.picture.display();
  keepPicture(with, "rays_room_kinds");
  EXPECT_GT(differentPixels(before.pixels, with.pixels), 2000u);
  EXPECT_EQ(rays.picture.linear(1).pixels, linearBefore.pixels);
  rays.layer->setVisible(false);
  EXPECT_EQ(rays.picture.display().pixels, before.pixels);
}

TEST(RaysInAScene, Pictures) {
  SceneRays rays("building", 1280, 720);
  const Camera camera = cameraNamed(rays.picture.scene, "top");
  rays.start(camera);
  vtkCamera* vtk = rays.picture.renderer->renderer()->GetActiveCamera();
  const PixelRays pixels(vtk, 1280, 720);
  const struct {
    const char* name;
    RayColoring coloring;
    int columns, rows;
  } shown[] = {{"point", RayColoring::Kind, 1, 1},
               {"kinds", RayColoring::Kind, 6, 4},
               {"distance", RayColoring::HitDistance, 12, 8},
               {"error", RayColoring::Error, 12, 8},
               {"face", RayColoring::Face, 12, 8},
               {"probe", RayColoring::Probe, 12, 8}};
  std::vector<std::uint8_t> previous = rays.picture.display().pixels;
  for (const auto& s : shown) {
    rays.filter->SetKindEnabled(RayKind::Eye, false);
    rays.layer->setColoring(s.coloring);
    rays.show(rays.sources->screenGrid(pixels, s.columns, s.rows));
    ASSERT_GT(rays.filter->GetOutput()->GetNumberOfCells(), 0);
    const ImageRgba8 image = rays.picture.display();
    keepPicture(image, std::string("rays_building_") + s.name);
    EXPECT_GT(differentPixels(previous, image.pixels), 500u) << s.name;
    previous = image.pixels;
  }
}

TEST(RaysInAScene, FarFromTheOriginTheSamePicture) {
  std::vector<std::uint8_t> here;
  for (const double away : {0.0, 1.0e6}) {
    SceneRays rays("room", 640, 360);
    Scene& scene = rays.picture.scene;
    const glm::dvec3 shift(away);
    scene.models[0].translation += shift;
    Camera camera = cameraNamed(scene, "main");
    camera.position += shift;
    camera.target += shift;
    for (Probe& probe : scene.probes) {
      probe.origin += shift;
      probe.box = {probe.box.min + shift, probe.box.max + shift};
      if (probe.influence) probe.influence = Box{probe.influence->min + shift, probe.influence->max + shift};
    }
    rays.start(camera);
    rays.show(rays.sources->over("floor", 24));
    const ImageRgba8 image = rays.picture.display();
    if (away == 0.0) {
      here = image.pixels;
    } else {
      const std::size_t different = differentPixels(here, image.pixels);
      std::printf("  moved by %.0e m: %zu of %zu pixels differ\n", away, different, here.size() / 4);
      EXPECT_LE(different, here.size() / 4 / 500);
    }
  }
}

}  // namespace
