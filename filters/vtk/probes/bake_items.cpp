#include "filters/vtk/probes/bake_items.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace boxprobe {

BakeItem ProbeItems::item(const ProbeJob& job, const Publish& publish) const {
  const auto faces = std::make_shared<FaceKeys>();
  BakeItem item;
  if (job.kind == JobKind::SkyMap) {
    item = sky();
  } else if (job.kind == JobKind::Picture) {
    item = picture(job);
  } else if (job.kind == JobKind::Realtime) {
    item = realtime(job, faces);
  } else {
    item = bounce(job, faces);
  }
  item.levels = [this, name = job.name](int levels) {
    if (name.empty()) return needs_->ofSky(levels);
    const auto index = entries_->find(name);
    return index ? needs_->ofProbe(*index, levels) : kAllLevels;
  };
  item.faceSize = job.faceSize;
  item.bounce = job.bounce;
  Probe as;  // as its capture begins
  if (const auto index = entries_->find(job.name)) {
    as = entries_->probe(*index);
    item.prefilter = prefilterSettings(as);
  }
  item.publish = [job, as, faces, publish](std::shared_ptr<const ProbeMaps> maps) {
    MadeMaps made{job, *faces, std::move(maps)};
    if (job.kind == JobKind::Realtime) {
      made.job.key = ProbeKeys::realtime(as, *faces);
      if (!keepsCapture(as)) made.faces = {};
    }
    publish(std::move(made));
  };
  return item;
}

BakeItem ProbeItems::sky() const {
  BakeItem item;
  item.sky = true;
  // A sun of a few pixels must not fall between samples.
  item.settings.samplesPerTexelSide = content_->skyImage ? 4 : 1;
  item.face = [this](int) { return FaceSource{nullptr, {content_->sky}, content_->lightPointers()}; };
  return item;
}

BakeItem ProbeItems::picture(const ProbeJob& job) const {
  BakeItem item;
  item.picture = sources_->pictures.picture(job.name);
  if (const auto index = entries_->find(job.name)) item.settings.originWorld = entries_->probe(*index).origin;
  return item;
}

// Nearest first, by the farthest point of their bounds as in the window (vtkCulledRenderer), so that what walls hide is
// not worked out.
FaceSource ProbeItems::faceSource(const Probe& probe, int face) const {
  FaceSource source;
  std::vector<std::pair<double, vtkProp*>> order;
  for (const std::size_t i : objectsInFace(keys_->world(), probe, face)) {
    const Box& bounds = keys_->world().objects[i].boundsWorld;
    const glm::dvec3 away = glm::max(glm::abs(bounds.min - probe.origin), glm::abs(bounds.max - probe.origin));
    order.emplace_back(glm::dot(away, away), content_->objects[i].actor);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& object : order) source.props.push_back(object.second);
  source.objects = source.props.size();
  source.culled = content_->objects.size() - source.objects;
  if (std::holds_alternative<ClearToSky>(probe.clear)) source.props.push_back(content_->sky);
  source.lights = content_->lightPointers();
  return source;
}

BakeItem ProbeItems::bounce(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) const {
  const Probe as = entries_->probe(*entries_->find(job.name));
  const bool drag = job.kind == JobKind::Drag;
  BakeItem item;
  item.settings = captureSettings(as);
  item.reflectNothing = !drag && job.bounce == 1;
  if (!drag && job.bounce > 1) {
    item.drawing = [this, job](bool begins) { begins ? seeBounce(job) : shown_->seeAgain(); };
  }
  if (std::holds_alternative<ClearToOpen>(as.clear)) item.drawing = shown_->withoutSky(std::move(item.drawing));
  item.face = [this, job, as, drag, faces](int face) {
    FaceSource source;
    const auto at = entries_->find(job.name);
    if (!drag && at) {
      std::string& key = (*faces)[static_cast<std::size_t>(face)];
      key = keys_->face(*at, job.bounce, face);
      if (!(*entries_)[*at].again) source.same = cache_->findFace(face, key);
    }
    return source.same ? source : faceSource(as, face);
  };
  return item;
}

// Every probe as it was captured a bounce before; null where that bounce does not show it. Realtime probes are not in
// anybody's bounces.
void ProbeItems::seeBounce(const ProbeJob& job) const {
  const auto of = entries_->find(job.name);  // the list may have changed since the job began
  if (!of) return;
  const BounceKeys& bounces = keys_->bounces();
  const std::vector<std::size_t>& sees = bounces.sees(*of);
  shown_->see([&](std::size_t i) -> std::shared_ptr<const ProbeMaps> {
    const bool seen = std::find(sees.begin(), sees.end(), i) != sees.end();
    const std::shared_ptr<const ProbeMaps> maps = seen ? cache_->find(bounces.key(i, job.bounce - 1)) : nullptr;
    // They are not on show, so nobody else sees to what is sampled of them; and they may be older than the materials.
    if (maps) maps->need(needs_->ofProbe(i, maps->radiance.levels()));
    return maps;
  });
}

// A realtime probe of several bounces sees the probes as they are, itself included, so each round adds a bounce: as
// many rounds as it has bounces after the last change, then it rests.
BakeItem ProbeItems::realtime(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) const {
  const Probe as = entries_->probe(*entries_->find(job.name));
  BakeItem item;
  item.settings = captureSettings(as);
  item.fewSteps = true;
  item.reflectNothing = as.bounces == 1;
  if (std::holds_alternative<ClearToOpen>(as.clear)) item.drawing = shown_->withoutSky({});
  item.face = [this, as, faces](int face) {
    const auto at = entries_->find(as.name);
    const auto f = static_cast<std::size_t>(face);
    (*faces)[f] = keys_->realtimeFace(as, face);
    FaceSource source = faceSource(as, face);
    if (!at) return source;
    const bool reflects = as.bounces > 1 && !faceView(keys_->world(), as, face).lighting.empty();
    if (!reflects && (*entries_)[*at].faces[f] == (*faces)[f]) source.same = shown_->drawn(*at).maps;
    return source;
  };
  return item;
}

}  // namespace boxprobe
