#include "filters/vtk/frame/mirror_set.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/vtk/scene/view_frustum.h"

namespace boxprobe {

namespace {

PictureView pictureView(vtkCamera* camera, double aspect, int width, int height) {
  PictureView view;
  camera->GetPosition(&view.eye.x);
  camera->GetDirectionOfProjection(&view.forward.x);
  camera->GetViewUp(&view.up.x);
  view.parallel = camera->GetParallelProjection() != 0;
  const vtkMatrix4x4* m = camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) view.clipFromView[column][row] = m->GetElement(row, column);
  }
  view.width = width;
  view.height = height;
  return view;
}

double highest(const Box& box, const MirrorPlane& plane) {
  return glm::dot(box.center() - plane.center, plane.normal) + glm::dot(0.5 * box.size(), glm::abs(plane.normal));
}

/// The nearest and farthest distance of a box along a direction from a position.
glm::dvec2 depths(const Box& box, const glm::dvec3& from, const glm::dvec3& along) {
  const double middle = glm::dot(box.center() - from, along), half = glm::dot(0.5 * box.size(), glm::abs(along));
  return {middle - half, middle + half};
}

/// A box's bounds in the picture from -1 to 1; everything if a corner is behind the eye.
struct ScreenBounds {
  glm::dvec2 low{1.0e300}, high{-1.0e300};
  void add(const Box& box, const PictureView& view) {
    const glm::dmat4 clipFromEye = view.clipFromView * view.viewFromEye();
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                         (corner & 4) != 0 ? box.max.z : box.min.z);
      const glm::dvec4 clip = clipFromEye * glm::dvec4(p - view.eye, 1.0);
      if (clip.w <= 0.0) {
        low = glm::dvec2(-1.0);
        high = glm::dvec2(1.0);
        return;
      }
      low = glm::min(low, glm::dvec2(clip) / clip.w);
      high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
  }
  bool meets(const ScreenBounds& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

/// Roughness is single precision: a material's 0.3 must not exceed 0.3.
bool tooRough(double roughness, const PlanarMirror& settings) {
  return static_cast<float>(roughness) > static_cast<float>(settings.maxRoughness);
}

double texelSize(const PictureView& view) {
  return 2.0 / (std::fabs(view.clipFromView[1][1]) * view.height);
}

/// Pixels around the mirror that its rays reach: where the widest of them ends at that height, seen from the eye. At
/// most a quarter of the picture, because the tail of a wide lobe is not worth its cost.
double blurMargin(const PictureView& view, const MirrorPlane& plane, double roughness, double farHeight) {
  if (roughness < 1.0e-3) return 0.0;
  const double spread = std::tan(std::min(2.0 * roughness * roughness, 1.2));
  const double away = view.parallel ? 1.0 : glm::distance(view.eye, plane.center);
  const double reach = view.parallel ? spread * farHeight : spread * farHeight / (away + farHeight);
  return std::min(reach / texelSize(view), 0.25 * std::max(view.width, view.height));
}

}  // namespace

Phrase mirrorStateText(MirrorState state) {
  switch (state) {
    case MirrorState::Disabled:
      return Phrase::tr("it is switched off, hidden, or not lit by probes");
    case MirrorState::Rough:
      return Phrase::tr("it is rougher than its maxRoughness");
    case MirrorState::FacingAway:
      return Phrase::tr("it faces away");
    case MirrorState::NotInView:
      return Phrase::tr("it is out of view");
    case MirrorState::NothingDynamic:
      return Phrase::tr("no dynamic object is in its view");
    case MirrorState::OverBudget:
      return Phrase::tr("larger mirrors used up the mirrorBudget");
    case MirrorState::Drawn:
    case MirrorState::NotDrawn:
      break;
  }
  return {};
}

MirrorSet::MirrorSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content)
    : window_(window), state_(std::move(state)), content_(content), painter_(window, state_, content) {}

std::vector<std::size_t> MirrorSet::dynamicObjects() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    const ObjectOverride& settings = content_->objects[i].settings;
    if (settings.visible && settings.dynamic) result.push_back(i);
  }
  return result;
}

void MirrorSet::update() {
  problem_.clear();
  std::vector<Mirror> before = std::move(mirrors_);
  mirrors_.clear();
  std::vector<std::shared_ptr<const MirrorPicture>> pictures(content_->objects.size());
  const std::vector<std::size_t> dynamic = dynamicObjects();
  for (const auto& [node, settings] : content_->scene.mirrors) {
    Mirror mirror;
    for (Mirror& old : before) {
      if (old.node != node) continue;
      mirror.picture = std::move(old.picture);
      mirror.target = std::move(old.target);
    }
    if (!mirror.picture) continue;
    mirror.node = node;
    mirror.settings = settings;
    try {
      const auto plane = mirrorPlane(content_->scene, content_->given, node);
      if (!plane) continue;
      mirror.plane = *plane;
    } catch (const InputError& error) {
      // The window continues without it; the message beside the mirror's name gives the reason.
      if (problem_.empty()) problem_ = error.what();
      continue;
    }
    bool visible = false;
    for (std::size_t i = 0; i < content_->objects.size(); ++i) {
      const DrawnObject& object = content_->objects[i];
      if (object.node != node) continue;
      mirror.objects.push_back(i);
      mirror.roughnessMin = std::min(mirror.roughnessMin, object.roughnessMin);
      mirror.roughnessMax = std::max(mirror.roughnessMax, object.roughnessMax);
      mirror.bumpy |= object.surface->slots[kNormalSlot].texture != nullptr;
      visible |= object.settings.visible;
    }
    mirror.settings.enabled &= visible;
    const bool anyMoves =
        std::any_of(dynamic.begin(), dynamic.end(), [&](std::size_t i) { return content_->objects[i].node != node; });
    mirror.usable = mirror.settings.enabled && anyMoves && !tooRough(mirror.roughnessMin, settings);
    for (const std::size_t i : mirror.objects) {
      if (mirror.usable) pictures[i] = mirror.picture;
    }
    if (!mirror.usable) mirror.target->release();
    mirrors_.push_back(std::move(mirror));
  }
  // Objects of mirrors with a picture keep their program; others get theirs with the first picture (see draw).
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    vtkProbePass* pass = content_->objects[i].pass;
    if (pass->GetMirror() != pictures[i]) pass->SetMirror(nullptr);
  }
}

void MirrorSet::count(MirrorState state) {
  MirrorCounters& c = state_->counts.counters.mirrors;
  switch (state) {
    case MirrorState::Drawn:
      ++c.drawn;
      break;
    case MirrorState::Disabled:
      ++c.disabled;
      break;
    case MirrorState::Rough:
      ++c.rough;
      break;
    case MirrorState::FacingAway:
      ++c.facingAway;
      break;
    case MirrorState::NotInView:
      ++c.notInView;
      break;
    case MirrorState::NothingDynamic:
      ++c.nothingDynamic;
      break;
    case MirrorState::OverBudget:
      ++c.overBudget;
      break;
    case MirrorState::NotDrawn:
      break;
  }
}

MirrorState MirrorSet::plan(std::size_t index, const PictureView& view, const std::vector<std::size_t>& dynamic,
                            Plan& plan) {
  const Mirror& mirror = mirrors_[index];
  plan.mirror = index;
  plan.plane = mirror.plane;
  if (!mirror.settings.enabled) return MirrorState::Disabled;
  // Without probes nothing is sampled, including mirrors' pictures.
  const ProbeBinding* binding = content_->objects[mirror.objects.front()].pass->GetDrawnBinding();
  if (binding == nullptr || binding->lighting != Lighting::Probes) return MirrorState::Disabled;
  if (tooRough(mirror.roughnessMin, mirror.settings)) return MirrorState::Rough;
  if (!mirror.usable) return MirrorState::NothingDynamic;
  if (!facesEye(plan.plane, view)) return MirrorState::FacingAway;
  const std::vector<glm::dvec2> part = visiblePart(plan.plane, view);
  if (part.empty()) return MirrorState::NotInView;
  plan.area = areaOf(part, view);
  plan.resolution = mirror.settings.resolution;

  // Objects in front of the mirror, up to its highest point; then those of them in its view.
  const double rounding = 1.0e-9 * glm::distance(plan.plane.corners[0], plan.plane.corners[2]);
  std::vector<std::size_t> before;
  double far = 0.0, height = 0.0;
  const glm::dvec3 along = view.forward - 2.0 * glm::dot(view.forward, plan.plane.normal) * plan.plane.normal;
  const glm::dvec3 eye = view.eye - 2.0 * glm::dot(view.eye - plan.plane.center, plan.plane.normal) * plan.plane.normal;
  for (const std::size_t i : dynamic) {
    const DrawnObject& object = content_->objects[i];
    if (object.node == mirror.node) continue;
    const Box box = worldBounds(object);
    if (highest(box, plan.plane) <= rounding) continue;
    before.push_back(i);
    height = std::max(height, highest(box, plan.plane));
    far = std::max(far, depths(box, eye, along).y);
  }
  if (before.empty() || far <= 0.0) return MirrorState::NothingDynamic;
  plan.farHeight = height;
  const MirrorRect rect = mirroredRect(part, view, blurMargin(view, plan.plane, mirror.roughnessMax, height));
  // Slightly farther: rounding would clip objects in the far plane itself.
  plan.view = mirroredView(plan.plane, view, rect, 1.01 * far);
  const ViewFrustum frustum(painter_.camera(plan.view), 1.0);
  for (const std::size_t i : before) {
    if (frustum.meets(worldBounds(content_->objects[i]))) plan.moving.push_back(i);
  }
  return plan.moving.empty() ? MirrorState::NothingDynamic : MirrorState::Drawn;
}

// Static objects in front of the mirror, nearer than the farthest moving object, that overlap moving ones on screen.
void MirrorSet::findHiding(Plan& plan, const std::vector<std::size_t>& own) {
  ScreenBounds moving;
  double far = 0.0;
  for (const std::size_t i : plan.moving) {
    const Box box = worldBounds(content_->objects[i]);
    moving.add(box, plan.view);
    far = std::max(far, depths(box, plan.view.eye, plan.view.forward).y);
  }
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    const DrawnObject& object = content_->objects[i];
    if (!object.settings.visible || object.settings.dynamic) continue;
    // Partial transparency cannot be represented by depth.
    if (object.material.alphaMode == AlphaMode::Blend || object.surface->glass.drawn) continue;
    if (std::find(own.begin(), own.end(), i) != own.end()) continue;
    const Box box = worldBounds(object);
    if (highest(box, plan.plane) <= 0.0) continue;
    if (depths(box, plan.view.eye, plan.view.forward).x > far) continue;
    ScreenBounds bounds;
    bounds.add(box, plan.view);
    if (bounds.meets(moving)) plan.hiding.push_back(i);
  }
}

void MirrorSet::draw(vtkCamera* camera, double aspect, int width, int height, int samples) {
  hide();
  state_->counts.counters.mirrors = {};
  reports_.clear();
  if (mirrors_.empty()) return;
  const PictureView view = pictureView(camera, aspect, width, height);
  const std::vector<std::size_t> dynamic = dynamicObjects();
  std::vector<Plan> plans;
  for (std::size_t i = 0; i < mirrors_.size(); ++i) {
    Plan planned;
    const MirrorState state = plan(i, view, dynamic, planned);
    reports_.push_back({mirrors_[i].node, state, 0, 0, 0, 0, planned.plane, glm::dvec3(0.0)});
    if (state == MirrorState::Drawn) plans.push_back(std::move(planned));
  }
  std::stable_sort(plans.begin(), plans.end(), [](const Plan& a, const Plan& b) { return a.area > b.area; });
  double left = content_->scene.mirrorBudget;
  for (Plan& p : plans) {
    const double wanted = static_cast<double>(p.view.width) * p.view.height * p.resolution * p.resolution;
    MirrorReport& report = reports_[p.mirror];
    // If its picture exceeds the budget it is drawn with a lower resolution, at least half along each axis; less would
    // be too blurred.
    const double scale = wanted > left ? std::sqrt(std::max(left, 0.0) / wanted) : 1.0;
    if (scale < 0.5) {
      report.state = MirrorState::OverBudget;
      continue;
    }
    p.resolution *= scale;
    left -= scale * scale * wanted;
    findHiding(p, mirrors_[p.mirror].objects);
    paint(p, view, samples);
    report.width = mirrors_[p.mirror].target->width();
    report.height = mirrors_[p.mirror].target->rows();
    report.objects = p.moving.size();
    report.hiding = p.hiding.size();
    report.plane = p.plane;
    report.eye = p.view.eye;
  }
  // Switches the programs of mirrors without a picture: what a frame cannot show must not be sampled.
  for (std::size_t i = 0; i < mirrors_.size(); ++i) {
    const Mirror& mirror = mirrors_[i];
    for (const std::size_t object : mirror.objects) {
      content_->objects[object].pass->SetMirror(mirror.picture->shown ? mirror.picture : nullptr);
    }
    count(reports_[i].state);
  }
}

void MirrorSet::paint(const Plan& plan, const PictureView& view, int samples) {
  Mirror& mirror = mirrors_[plan.mirror];
  const auto texels = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * plan.resolution))); };
  const bool mips = mirror.roughnessMax >= 1.0e-3 || mirror.bumpy || plan.resolution > 1.0;
  mirror.target->allocate(texels(plan.view.width), texels(plan.view.height), samples, mips);
  const glm::dvec4 heights(plan.plane.normal, glm::dot(plan.plane.normal, plan.view.eye - plan.plane.center));
  painter_.paint(plan.view, heights / plan.farHeight, plan.moving, plan.hiding, *mirror.target);
  state_->counts.counters.mirrors.texels +=
      static_cast<std::uint64_t>(mirror.target->width()) * static_cast<std::uint64_t>(mirror.target->rows());

  // Positions relative to the eye, as in the shader.
  glm::dmat4 toMirrored(1.0);
  toMirrored[3] = glm::dvec4(view.eye - plan.view.eye, 1.0);
  const glm::dmat4 clip = plan.view.clipFromView * plan.view.viewFromEye() * toMirrored;
  const auto row = [&](int i) { return glm::dvec4(clip[0][i], clip[1][i], clip[2][i], clip[3][i]); };
  MirrorPicture& picture = *mirror.picture;
  picture.color = mirror.target->color();
  picture.height = mirror.target->height();
  shading::MirrorLook& look = picture.look;
  look.toU = glm::vec4(0.5 * (row(0) + row(3)));
  look.toV = glm::vec4(0.5 * (row(1) + row(3)));
  look.toW = glm::vec4(row(3));
  look.normal = glm::vec3(plan.plane.normal);
  look.farHeight = static_cast<float>(plan.farHeight);
  look.eye = glm::vec3(plan.view.eye - view.eye);
  look.texelSize = static_cast<float>(texelSize(view) / plan.resolution);
  look.parallel = view.parallel ? 1.0f : 0.0f;
  look.sizeX = static_cast<float>(mirror.target->width());
  look.sizeY = static_cast<float>(mirror.target->rows());
  look.maxLevel = static_cast<float>(mirror.target->levels() - 1);
  look.sharpLevel = std::min(static_cast<float>(std::log2(std::max(plan.resolution, 1.0))), look.maxLevel);
  picture.shown = true;
}

void MirrorSet::hide() {
  for (Mirror& mirror : mirrors_) {
    mirror.picture->shown = false;
    mirror.picture->texels.reset();
  }
}

void MirrorSet::readBack() {
  for (Mirror& mirror : mirrors_) {
    if (mirror.picture->shown) mirror.picture->texels = mirror.target->readBack();
  }
}

std::size_t MirrorSet::memoryBytes() const {
  std::size_t bytes = 0;
  for (const Mirror& mirror : mirrors_) {
    if (mirror.target->framebuffer() != 0) bytes += mirror.target->bytes();
  }
  return bytes;
}

void MirrorSet::release() {
  hide();
  for (Mirror& mirror : mirrors_) mirror.target->release();
  painter_.release();
}

}  // namespace boxprobe
