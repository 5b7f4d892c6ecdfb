#include "filters/vtk/inspect/surface_inspector.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkProperty.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "filters/core/base/errors.h"
#include "filters/math/technique/automatic.h"
#include "filters/vtk/draw/probe_lamps.h"
#include "filters/vtk/draw/probe_lattice.h"
#include "filters/vtk/gl/program_check.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

// What a pixel shows is explained: not what the window hides or cuts away.
static bool inView(const DrawnObject& object) {
  return object.settings.visible && !object.pass->GetHiddenInView();
}

SurfaceInspector::SurfaceInspector(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state,
                                   SceneContent* content)
    : window_(window), state_(std::move(state)), content_(content), capture_(window, state_) {}

vtkProp* SurfaceInspector::twinOf(std::size_t index) {
  const DrawnObject& object = content_->objects[index];
  vtkSmartPointer<vtkProbeActor>& twin = twins_[index];
  if (!twin) {
    twin = makeTwin(object, state_);
    twin->GetPass()->SetDebug(true);
    twin->GetPass()->SetObjectNumber(static_cast<int>(index) + 1);
  }
  twin->SetUserMatrix(object.actor->GetUserMatrix());
  twin->GetPass()->SetCut(state_->cut.has_value());
  twin->GetPass()->SetBinding(object.pass->GetSharedBinding());
  twin->GetPass()->SetMirror(object.pass->GetMirror());
  return twin;
}

// The objects whose projected bounds contain the pixel: others cannot be visible there.
std::vector<vtkProp*> SurfaceInspector::twinsAt(vtkCamera* camera, double aspect, const glm::dvec2& center,
                                                const glm::dvec2& halfSize) {
  vtkMatrix4x4* clipFromWorld = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  std::vector<vtkProp*> result;
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    if (!inView(content_->objects[i])) continue;
    const Box box = worldBounds(content_->objects[i]);
    glm::dvec2 low(1e300), high(-1e300);
    bool behind = false;
    for (int corner = 0; corner < 8; ++corner) {
      const double world[4] = {(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                               (corner & 4) != 0 ? box.max.z : box.min.z, 1.0};
      double clip[4];
      clipFromWorld->MultiplyPoint(world, clip);
      behind = behind || clip[3] <= 0.0;
      const glm::dvec2 screen(clip[0] / clip[3], clip[1] / clip[3]);
      low = glm::min(low, screen);
      high = glm::max(high, screen);
    }
    // If a corner is behind the eye the projection is meaningless; the object is drawn.
    const bool covers = glm::all(glm::lessThanEqual(low, center + halfSize)) &&
                        glm::all(glm::greaterThanEqual(high, center - halfSize));
    if (behind || covers) result.push_back(twinOf(i));
  }
  return result;
}

// In a separate pass, because few scenes have such surfaces.
bool SurfaceInspector::needsFinish() const {
  return std::any_of(content_->objects.begin(), content_->objects.end(), [](const DrawnObject& object) {
    const SurfaceMaterial& surface = *object.surface;
    const bool glass = surface.slots[kThicknessSlot].texture || surface.slots[kTransmissionSlot].texture;
    return surface.finished() || (surface.glass.drawn && glass);
  });
}

std::shared_ptr<const BakedMaps> SurfaceInspector::onCpu(const std::shared_ptr<const ProbeMaps>& maps) {
  if (!maps) return nullptr;
  copies_.erase(std::remove_if(copies_.begin(), copies_.end(), [](const Copy& c) { return c.of.expired(); }),
                copies_.end());
  for (Copy& copy : copies_) {
    if (copy.of.lock() != maps) continue;
    if (copy.filtered != maps->filtered) {
      copy.maps = std::make_shared<const BakedMaps>(readBackAsShown(*maps));
      copy.filtered = maps->filtered;
    }
    return copy.maps;
  }
  copies_.push_back({maps, maps->filtered, std::make_shared<const BakedMaps>(readBackAsShown(*maps))});
  return copies_.back().maps;
}

std::vector<Explanation> SurfaceInspector::explain(vtkCamera* camera, int width, int height,
                                                   const std::vector<glm::ivec2>& pixels) {
  const bool single = pixels.size() == 1;
  PixelRect rect{0, 0, width, height};
  if (single) rect = {pixels[0].x, pixels[0].y, 1, 1};
  std::vector<SurfacePixel> surfaces;
  std::vector<vtkProp*> props;
  const std::vector<vtkLight*> lights = content_->lightPointers();
  if (single) {
    const glm::dvec2 halfSize(1.0 / width, 1.0 / height);
    const glm::dvec2 center((2.0 * pixels[0].x + 1.0) / width - 1.0, 1.0 - (2.0 * pixels[0].y + 1.0) / height);
    props = twinsAt(camera, static_cast<double>(width) / height, center, halfSize);
  } else {
    for (std::size_t i = 0; i < content_->objects.size(); ++i) {
      if (inView(content_->objects[i])) props.push_back(twinOf(i));
    }
  }
  surfaces = capture_.capture(camera, width, height, rect, props, lights, needsFinish());
  requireTold(props, surfaces);
  const auto at = [&](const glm::ivec2& p) {
    return single ? std::size_t{0} : static_cast<std::size_t>(p.y * width + p.x);
  };
  const bool anyBackground =
      std::any_of(pixels.begin(), pixels.end(), [&](const glm::ivec2& p) { return surfaces[at(p)].object == 0; });
  std::vector<SurfacePixel> sky;
  if (anyBackground) sky = capture_.capture(camera, width, height, rect, {content_->sky}, lights);

  readMovingMaps();
  std::vector<Explanation> result;
  result.reserve(pixels.size());
  for (const glm::ivec2& p : pixels) {
    const SurfacePixel& surface = surfaces[at(p)];
    Explanation e;
    if (surface.object == 0) {
      e.color = sky[at(p)].color;
      e.rendered = e.color;
      e.notes.push_back(
          Phrase::tr("No surface at this pixel: it shows the sky, so there is no point, normal or reflected ray."));
    } else {
      e = explainOne(surface);
    }
    e.x = p.x;
    e.y = p.y;
    result.push_back(std::move(e));
  }
  return result;
}

// After programs that write only the first attachment, the others are undefined.
void SurfaceInspector::requireTold(const std::vector<vtkProp*>& props, const std::vector<SurfacePixel>& pixels) const {
  const bool refused = std::any_of(twins_.begin(), twins_.end(), [&](const auto& entry) {
    vtkProbeActor* twin = entry.second;
    return twin->GetPass()->GetDebugRefused() && std::find(props.begin(), props.end(), twin) != props.end();
  });
  const int count = static_cast<int>(content_->objects.size());
  const bool wrong = std::any_of(pixels.begin(), pixels.end(),
                                 [&](const SurfacePixel& pixel) { return pixel.object < 0 || pixel.object > count; });
  if (refused || wrong) throw WorkError(kExplainRefused);
}

void SurfaceInspector::readMovingMaps() {
  movingMaps_.clear();
  sunMaps_.clear();
  const auto read = [this](MovingMap map, GLuint texture) {
    const auto side = static_cast<std::size_t>(map.size);
    auto depth = std::make_shared<std::vector<float>>(side * side);
    const BoundTexture bound(window_, GL_TEXTURE_2D, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth->data());
    map.depth = std::move(depth);
    return map;
  };
  for (const MovingShadow& shadow : state_->resources.movingShadows) {
    movingMaps_.push_back(
        read({shadow.light, kMovingMapSize, {}, shadow.mapFromWorld, glm::dvec2(1.0 / kMovingMapSize), 0.0},
             shadow.texture));
  }
  for (const SunShadow& sun : state_->resources.sunShadows) {
    const MovingMap map{sun.light, sun.size, {}, sun.mapFromWorld, glm::dvec2(sun.apart), static_cast<double>(sun.off)};
    sunMaps_.push_back(sun.texture != 0 ? read(map, sun.texture) : map);
  }
}

namespace {

PointFinish pointFinish(const SurfacePixel& pixel, const SurfaceMaterial& surface) {
  PointFinish finish;
  finish.f0 = glm::vec3(pixel.finish[0]);
  finish.edge = pixel.finish[0].w;
  finish.tinted = surface.finish.tintsSpecular();
  finish.sheenColor = glm::vec3(pixel.finish[1]);
  finish.sheenRoughness = pixel.finish[1].w;
  finish.acrossWorld = glm::vec3(pixel.finish[2]);
  finish.anisotropy = pixel.finish[2].w;
  finish.iridescence = pixel.finish[3].x;
  finish.filmThickness = pixel.finish[3].y;
  finish.filmIor = surface.finish.filmIor;
  return finish;
}

}  // namespace

Explanation SurfaceInspector::explainOne(const SurfacePixel& pixel) {
  const DrawnObject& object = content_->objects[static_cast<std::size_t>(pixel.object - 1)];
  const ProbeBinding& binding = *object.pass->GetBinding();
  ExplainInput in;
  in.surface = pixel.point;
  in.surface.object = object.node;
  in.surface.material = object.materialName;
  in.surface.frame = state_->pass().frame;
  if (object.surface->finished() && !object.pass->DrawsGlass()) in.surface.finish = pointFinish(pixel, *object.surface);
  in.lighting = binding.lighting == Lighting::Probes  ? ExplainInput::Lighting::Probes
                : binding.lighting == Lighting::Unlit ? ExplainInput::Lighting::Unlit
                                                      : ExplainInput::Lighting::Plain;
  const std::vector<int> groups = binding.groups();
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& drawn = *binding.probes[i];
    ExplainedProbe probe;
    probe.index = drawn.index;
    probe.name = content_->scene.probes[static_cast<std::size_t>(drawn.index)].name;
    probe.group = groups[i];
    probe.geometry = drawn.geometry;
    probe.automatic = isAutomatic(probe.geometry.technique);
    probe.geometry.technique = binding.technique(i);
    probe.maps = onCpu(drawn.maps).get();
    probe.open = drawn.open;
    probe.openSky = drawn.openSky;
    probe.shadowLights = drawn.shadowLights;
    if (drawn.maps) probe.coverage = drawn.maps->coverage.chain().get();
    probe.lattice = probeLattice(*state_, drawn);
    if (drawn.maps && binding.lampFree(i)) probe.lampFree = onCpu(drawn.maps->lampFree.maps).get();
    if (probe.lattice || probe.lampFree != nullptr) {
      for (const std::size_t lamp : drawn.lamps) {
        probe.lamps.push_back(content_->lamps->lamps[lamp]);
        probe.lampGlossy.push_back(lampReflected(*state_, binding, lamp));
        if (drawn.sight) probe.lampChannels.push_back(drawn.sight->channelOfLamp(lamp));
      }
    }
    probe.sight = drawn.sight;
    in.probes.push_back(std::move(probe));
  }
  in.weights = binding.weights;
  in.sky = binding.sky;
  in.diffuse = binding.diffuse;
  in.onlyProbes = binding.onlyProbes;
  in.shares = binding.shares;
  in.skyShare = binding.skyShare;
  in.skyMaps = onCpu(state_->resources.sky).get();
  if (binding.openness) in.openness = state_->resources.openness;
  in.energy = content_->scene.energy;
  in.lights = content_->scene.lights;
  for (std::size_t i = 0; content_->lamps && i < content_->lamps->lamps.size(); ++i) {
    if (const auto light = content_->lamps->lamps[i].light) in.lights[*light].intensity = 0.0f;  // the lamp counts
  }
  if (object.pass->DrawsGlass()) {
    int faceSize = state_->resources.sky ? state_->resources.sky->radiance.faceSize() : 0;
    for (const auto& probe : binding.probes) {
      if (probe->maps) faceSize = std::max(faceSize, probe->maps->radiance.faceSize());
    }
    in.glass = object.surface->glass.explained(in.surface.eyeWorld, faceSize);
    if (object.surface->slots[kThicknessSlot].texture) in.glass->object.thickness *= pixel.finish[0].x;
    if (object.surface->slots[kTransmissionSlot].texture) in.glass->transmission *= pixel.finish[0].y;
    in.surface.transmission = in.glass->transmission;
  }
  shading::MirrorLook look{};
  const auto mirror = object.pass->GetMirror();
  if (mirror != nullptr && mirror->shown) {
    look = mirror->look;
    look.picture = mirror->texels.get();
    in.mirror = &look;
  }
  in.shadowLights = binding.shadowLights;
  in.sightLights = binding.sightLights;
  in.movingMaps = movingMaps_;
  for (const SunUse& sun : binding.sunLights) {
    if (sun.map < sunMaps_.size() && sunMaps_[sun.map].depth) in.sunMaps.push_back(sunMaps_[sun.map]);
  }
  Explanation e = explainPixel(in);
  e.rendered = pixel.color;
  return e;
}

void SurfaceInspector::release() {
  capture_.release();
  for (auto& [index, twin] : twins_) twin->ReleaseGraphicsResources(window_);
  twins_.clear();
  copies_.clear();
}

}  // namespace boxprobe
