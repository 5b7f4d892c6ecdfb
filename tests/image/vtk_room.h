// A room such as a plain VTK program makes it, for the tests of probes on somebody else's actors.
#pragma once

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <array>
#include <cmath>
#include <vector>

#include "filters/vtk/actors/actor_probes.h"
#include "filters/vtk/gl/window_pixels.h"
#include "tests/support/gpu_window.h"

namespace boxprobe::test {

using Point = std::array<double, 3>;

inline vtkSmartPointer<vtkActor> plane(const Point& origin, const Point& a, const Point& b, double scale = 1.0) {
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(scale * origin[0], scale * origin[1], scale * origin[2]);
  source->SetPoint1(scale * a[0], scale * a[1], scale * a[2]);
  source->SetPoint2(scale * b[0], scale * b[1], scale * b[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

inline void makeMirror(vtkActor* actor) {
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetMetallic(1.0);
  actor->GetProperty()->SetRoughness(0.0);
}

inline void makeUnlit(vtkActor* actor, double r, double g, double b) {
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetColor(r, g, b);
}

/// A room of 4 x 2 x 4 units about the origin with a mirror as its floor and unlit walls: red at -x, green at +x, grey
/// at -z, blue at +z, a white ceiling. Seen from within, towards -z and down.
struct Room {
  explicit Room(double size = 1.0) : scale(size) {
    floor = plane({-2, -1, 2}, {2, -1, 2}, {-2, -1, -2}, scale);
    makeMirror(floor);
    const std::array<std::array<Point, 3>, 5> walls = {{{{{-2, -1, 2}, {-2, -1, -2}, {-2, 1, 2}}},
                                                        {{{2, -1, -2}, {2, -1, 2}, {2, 1, -2}}},
                                                        {{{-2, -1, -2}, {2, -1, -2}, {-2, 1, -2}}},
                                                        {{{2, -1, 2}, {-2, -1, 2}, {2, 1, 2}}},
                                                        {{{-2, 1, -2}, {2, 1, -2}, {-2, 1, 2}}}}};
    const std::array<Point, 5> colors = {{{1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0.5}, {0, 0, 1}, {1, 1, 1}}};
    for (std::size_t i = 0; i < walls.size(); ++i) {
      others.push_back(plane(walls[i][0], walls[i][1], walls[i][2], scale));
      makeUnlit(others.back(), colors[i][0], colors[i][1], colors[i][2]);
    }
    renderer->AddActor(floor);
    for (const auto& wall : others) renderer->AddActor(wall);
    vtkNew<vtkLight> dark;
    dark->SetIntensity(0.0);
    renderer->AddLight(dark);
    look(renderer, 0.0);
    window->AddRenderer(renderer);
  }
  ~Room() { window->RemoveRenderer(renderer); }

  void look(vtkRenderer* by, double x) const {
    vtkCamera* camera = by->GetActiveCamera();
    camera->SetPosition(scale * x, 0.0, scale * 1.9);
    camera->SetFocalPoint(scale * x, -0.45 * scale, 0.0);
    camera->SetViewUp(0, 1, 0);
    camera->SetViewAngle(60);
    camera->SetClippingRange(0.01 * scale, 20.0 * scale);
  }
  Probe probe() const {
    Probe made;
    made.box = {glm::dvec3(-2.0, -1.0, -2.0) * scale, glm::dvec3(2.0, 1.0, 2.0) * scale};
    made.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
    made.faceSize = 64;
    return made;
  }
  void addAll(ActorProbes& probes) const {
    probes.addActor(floor, false);
    for (const auto& wall : others) probes.addActor(wall);
  }
  ImageRgba8 picture() const {
    window->Render();
    return windowPixels(window);
  }

  double scale;
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow(160, 160);
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkActor> floor;
  std::vector<vtkSmartPointer<vtkActor>> others;
};

/// Rows from the top.
inline std::array<int, 3> at(const ImageRgba8& image, int x, int y) {
  const auto i = static_cast<std::size_t>(y * image.width + x) * 4;
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

inline double meanDifference(const ImageRgba8& a, const ImageRgba8& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
  return sum / static_cast<double>(a.pixels.size());
}

inline void expectNear(const std::array<int, 3>& found, const std::array<int, 3>& wanted, int off) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], off) << "channel " << i;
}

// Where the floor shows the grey wall, below its foot at the picture's middle.
constexpr int kMirroredX = 80, kMirroredY = 112;

}  // namespace boxprobe::test
