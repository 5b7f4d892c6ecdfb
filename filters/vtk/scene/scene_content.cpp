#include "filters/vtk/scene/scene_content.h"

#include <algorithm>

#include "filters/core/geometry/divide_model.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/scene/material_override.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/vtk/maps/content_hash.h"
#include "filters/vtk/scene/object_memory.h"
#include "filters/vtk/scene/scene_lights.h"
#include "filters/vtk/scene/vtkCulledRenderer.h"

namespace boxprobe {

// A moved model keeps its actors: geometry, textures and programs stay on the GPU.
bool SceneContent::placeObjects() {
  if (models != builtModels_ || scene.models.size() != builtFiles_.size()) return false;
  for (std::size_t i = 0; i < builtFiles_.size(); ++i) {
    if (scene.models[i].file != builtFiles_[i]) return false;
  }
  auto object = objects.begin();
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    for (const Instance& instance : models[i]->instances) placeObject(*object++, instance, scene.models[i]);
  }
  return true;
}

namespace {

// All inputs of sceneLamps(). Objects without emission count by their area, which movements do not change.
std::string lampSourcesKey(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  ContentHash hash;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    const Model& model = *models[i];
    hash.add(scene.models[i].scale);
    hash.add(static_cast<int>(scene.models[i].unit)).add(static_cast<int>(scene.models[i].upAxis));
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    std::vector<char> shines;
    for (const Material& given : model.materials) {
      const Material material = overriddenMaterial(given, scene);
      const glm::vec3 light = material.unlit ? glm::vec3(material.baseColor) : material.emissive;
      shines.push_back(light.x > 0.0f || light.y > 0.0f || light.z > 0.0f);
      if (shines.back()) hash.addVector(light).add(material.doubleSided ? 1 : 0);
    }
    for (const Instance& instance : model.instances) {
      const auto settings = scene.objects.find(instance.node);
      const bool seen = settings == scene.objects.end() ||
                        (settings->second.visible && settings->second.seenByProbes && !settings->second.dynamic);
      hash.add(seen ? 1 : 0);
      const int material = model.meshes[static_cast<std::size_t>(instance.mesh)].material;
      if (!seen || material < 0 || !shines[static_cast<std::size_t>(material)]) continue;
      const glm::dmat4 world = movedInstance(placement * instance.worldFromModel, scene, instance.node);
      hash.addBytes(&world, sizeof world);
    }
  }
  for (const Light& light : scene.lights) {  // its power decides whether a lamp stands for it
    hash.add(static_cast<int>(light.type)).addVector(light.position).addVector(light.color).add(light.intensity);
  }
  return hash.text();
}

// From this many objects on, occlusion culling pays off.
constexpr std::size_t kMany = 64;

bool samePieces(const Model& a, const Model& b) {
  const auto sameMesh = [](const Mesh& m, const Mesh& n) {
    return m.positions == n.positions && m.indices == n.indices;
  };
  const auto sameInstance = [](const Instance& m, const Instance& n) {
    return m.mesh == n.mesh && m.node == n.node && m.worldFromModel == n.worldFromModel;
  };
  return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(), sameMesh) &&
         std::equal(a.instances.begin(), a.instances.end(), b.instances.begin(), b.instances.end(), sameInstance);
}

}  // namespace

bool SceneContent::divideModels() {
  const bool contested = scene.probes.size() > ProbeBinding::kMaxProbesPerDraw;
  const ProbeIndex index = contested ? ProbeIndex(scene.probes) : ProbeIndex();
  std::vector<std::shared_ptr<const Model>> divided = given;
  for (std::size_t i = 0; contested && i < given.size() && i < scene.models.size(); ++i) {
    divided[i] =
        dividedModel(given[i], worldFromFile(scene.models[i]), scene.probes, index, ProbeBinding::kMaxProbesPerDraw);
    // Divided as before: already drawn.
    const bool cut = divided[i] != given[i] && i < models.size() && models[i] != given[i];
    if (cut && samePieces(*divided[i], *models[i])) divided[i] = models[i];
  }
  if (divided == models) return false;
  models = std::move(divided);
  return true;
}

void SceneContent::showObjects(vtkCulledRenderer* renderer) {
  const bool now = objects.size() > kMany;
  if (many && !now) renderer->SetCulledProps({}, {});
  if (!now || !many) {
    for (DrawnObject& object : objects) {
      if (now && !object.surface->glass.drawn) {
        renderer->RemoveActor(object.actor);
      } else if (renderer->HasViewProp(object.actor) == 0) {
        renderer->AddActor(object.actor);
      }
    }
  }
  // Blended objects are drawn last, also after the sky.
  for (DrawnObject& object : objects) {
    if (!object.surface->glass.drawn) continue;
    renderer->RemoveActor(object.actor);
    renderer->AddActor(object.actor);
  }
  many = now;
  culled.clear();
  if (!many) return;
  std::vector<vtkProp*> props;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].settings.visible || objects[i].surface->glass.drawn) continue;
    culled.push_back(i);
    props.push_back(objects[i].actor);
    boxes.push_back(worldBounds(objects[i]));
  }
  culledBounds = bounds();
  renderer->SetCulledProps(std::move(props), boxes);
}

std::vector<vtkProp*> SceneContent::shownProps(vtkCulledRenderer* renderer) const {
  std::vector<vtkProp*> props;
  if (many) {
    for (const std::size_t i : renderer->InView()) props.push_back(objects[culled[i]].actor);
    for (const DrawnObject& object : objects) {
      if (object.surface->glass.drawn && object.settings.visible) props.push_back(object.actor);
    }
    return props;
  }
  for (const DrawnObject& object : objects) {
    if (object.settings.visible) props.push_back(object.actor);
  }
  return props;
}

// If there are many objects, those in view count: including others would only reduce depth precision.
void SceneContent::resetClippingRange(vtkCulledRenderer* renderer) const {
  if (!many) return renderer->ResetCameraClippingRange();
  Box box;
  bool any = false;
  for (const std::size_t i : renderer->InView()) {
    const Box b = worldBounds(objects[culled[i]]);
    box = any ? Box{glm::min(box.min, b.min), glm::max(box.max, b.max)} : b;
    any = true;
  }
  if (!any) box = culledBounds;
  const double bounds[6] = {box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z};
  renderer->ResetCameraClippingRange(bounds);
}

void SceneContent::rebuildObjects(vtkCulledRenderer* renderer, const std::shared_ptr<DrawState>& state) {
  if (!objects.empty() && placeObjects()) return;
  requireMemoryForObjects(scene, models);
  builtModels_ = models;
  builtFiles_.clear();
  for (const ModelFile& file : scene.models) builtFiles_.push_back(file.file);
  renderer->SetCulledProps({}, {});
  for (DrawnObject& object : objects) renderer->RemoveActor(object.actor);
  many = false;
  objects.clear();
  ++modelGeneration;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    for (DrawnObject& object : makeObjects(*models[i], scene.models[i], state)) {
      objects.push_back(std::move(object));
    }
  }
  if (objects.size() <= kMany) {
    for (DrawnObject& object : objects) renderer->AddActor(object.actor);
  }
  // Drawn last: it only fills what nothing else covers.
  renderer->RemoveViewProp(sky);
  renderer->AddViewProp(sky);
  renderer->SetBackdrop(sky);
}

bool SceneContent::findLamps() {
  const auto before = lamps;
  std::string key;
  if (scene.lamps == LampForm::Shapes) key = std::to_string(modelGeneration) + " " + lampSourcesKey(scene, given);
  const bool others = key != lampsKey_;
  if (others) {
    lampsKey_ = std::move(key);
    foundLamps_ = lampsKey_.empty() ? nullptr : std::make_shared<const SceneLamps>(sceneLamps(scene, given));
  }
  std::vector<bool> alone = lightsAlone();
  if (!others && alone == lightsAlone_) return false;
  lightsAlone_ = std::move(alone);
  lamps = foundLamps_;
  if (std::find(lightsAlone_.begin(), lightsAlone_.end(), true) != lightsAlone_.end()) {
    auto counted = std::make_shared<SceneLamps>(*foundLamps_);
    for (std::size_t i = 0; i < lightsAlone_.size(); ++i) {
      if (lightsAlone_[i]) counted->lamps[i].light.reset();
    }
    lamps = std::move(counted);
  }
  return lamps != before;
}

std::vector<bool> SceneContent::lightsAlone() const {
  if (!foundLamps_) return {};
  const std::vector<SceneLamp>& all = foundLamps_->lamps;
  std::vector<bool> alone(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) alone[i] = all[i].light.has_value();
  for (const Probe& probe : scene.probes) {
    if (!probesDrawn || std::find(alone.begin(), alone.end(), true) == alone.end()) break;
    if (probe.mode == ProbeMode::Custom || !probe.hasLattice()) continue;  // its diffuse light is its map's
    for (const std::size_t lamp : probeLamps(all, probe)) alone[lamp] = false;
  }
  return alone;
}

void SceneContent::rebuildLights(vtkRenderer* renderer, SceneResources& resources) {
  renderer->RemoveAllLights();
  const glm::dvec3 center = bounds().center();
  VtkLights made = makeLights(scene, center);
  lights = std::move(made.lights);
  // Light and lamp are counted once. The light stays among VTK's, because shadows use its index.
  std::vector<bool> counted(scene.lights.size(), false);
  for (std::size_t i = 0; lamps && i < lamps->lamps.size(); ++i) {
    const auto light = lamps->lamps[i].light;
    if (!light) continue;
    counted[*light] = true;
    if (made.places[*light] >= 0) lights[static_cast<std::size_t>(made.places[*light])]->SetIntensity(0.0);
  }
  std::vector<Light> listed;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (made.places[i] < 0 && !counted[i]) listed.push_back(scene.lights[i]);
  }
  resources.listedLights->set(listed, center);
  const bool all = std::find(made.places.begin(), made.places.end(), -1) == made.places.end();
  resources.lightPlaces = all ? std::vector<int>() : std::move(made.places);
  for (auto& light : lights) renderer->AddLight(light);
}

bool SceneContent::setScene(const Scene& wanted, bool newSky) {
  const std::vector<Light> before(scene.lights.begin() + static_cast<std::ptrdiff_t>(lightsGiven), scene.lights.end());
  scene = wanted;
  lightsGiven = scene.lights.size();
  if (newSky) rebuildSky();
  std::vector<Light> now;
  if (sun_) now.push_back(lightOf(*sun_, scene.skyRotationDegrees));
  scene.lights.insert(scene.lights.end(), now.begin(), now.end());
  return now != before;
}

Scene SceneContent::givenScene() const {
  Scene without = scene;
  without.lights.resize(lightsGiven);
  return without;
}

void SceneContent::rebuildSky(bool sunStays) {
  const auto* image = std::get_if<SkyImage>(&scene.sky);
  if (image == nullptr) {
    skyImage.reset();
    skyNotes = {};
    sun_.reset();
    skyImageRead_.reset();
  } else if (!(skyImageRead_ == *image)) {
    SkyImage wanted = *image;
    if (sunStays) wanted.sun = SkySunForm::InPicture;
    DrawnSky drawn = loadDrawnSky(wanted);
    skyImage = std::make_shared<ImageRgbaF>(std::move(drawn.image));
    skyNotes = std::move(drawn.notes);
    sun_ = drawn.sun;
    skyImageRead_ = *image;
  }
  sky->SetSky(scene.sky, scene.skyRotationDegrees, skyImage);
  sky->SetSun(sun_);
}

Box SceneContent::bounds() const {
  Box box;
  bool any = false;
  for (const DrawnObject& object : objects) {
    if (!object.settings.visible) continue;
    const Box b = worldBounds(object);
    box = any ? Box{glm::min(box.min, b.min), glm::max(box.max, b.max)} : b;
    any = true;
  }
  return box;
}

std::vector<vtkLight*> SceneContent::lightPointers() const {
  std::vector<vtkLight*> pointers;
  pointers.reserve(lights.size());
  for (const auto& light : lights) pointers.push_back(light);
  return pointers;
}

}  // namespace boxprobe
