#include "filters/vtk/probes/probe_keys.h"

#include <algorithm>

#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

BounceKeys::Input ProbeKeys::input(const Probe& probe) const {
  BounceKeys::Input input;
  input.bounces = probe.bounces;
  input.lattices = world_.lattices;
  input.imported = probe.mode == ProbeMode::Custom;
  input.realtime = probe.mode == ProbeMode::Realtime;
  CaptureView view = probeView(world_, probe);
  input.view = input.imported ? sources_->pictures.key(probe) : view.key;
  input.lighting = std::move(view.lighting);
  if (const auto it = records_.find(input.view); it != records_.end()) {
    input.record = it->second;
  } else {
    input.record = sources_->folder.record(input.view);
  }
  return input;
}

// Only of probes that are wanted or there already, and of those that their further bounces show.
BounceKeys ProbeKeys::asked(const std::set<std::string>& targets) const {
  const std::vector<Probe>& probes = entries_->scene().probes;
  std::vector<BounceKeys::Input> inputs(probes.size());
  std::vector<int> bounces(probes.size(), 0);  // up to which it is asked for
  std::vector<std::size_t> open;
  const auto ask = [&](std::size_t i, int upTo) {
    upTo = std::min(upTo, probes[i].bounces);
    if (upTo <= bounces[i]) return;
    bounces[i] = upTo;
    open.push_back(i);
  };
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const ProbeEntry& entry = (*entries_)[i];
    const bool target = targets.count(probes[i].name) != 0;
    if (entry.needed() || target || !entry.shown.empty() || probes[i].mode == ProbeMode::Realtime)
      ask(i, probes[i].bounces);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (inputs[i].view.empty()) inputs[i] = input(probes[i]);
    if (bounces[i] < 2) continue;
    for (const std::size_t other : inputs[i].lighting) ask(other, bounces[i] - 1);
    // What it was made from may be other probes than those its boxes name now. And a file names all probes there were,
    // the same ones whoever bakes a part of them.
    const bool all = inputs[i].record || targets.count(probes[i].name) != 0;
    for (std::size_t other = 0; all && other < probes.size(); ++other) ask(other, bounces[i] - 1);
  }
  return BounceKeys(std::move(inputs));
}

void ProbeKeys::update(const std::set<std::string>& targets) {
  ProbeEntries& entries = *entries_;
  bounces_ = asked(targets);
  // A record that no longer leads to maps has served: what is made now follows the boxes as they are now.
  bool dropped = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string& key = bounces_.finalKey(i);
    if (key.empty() || !entries.baked(i) || entries[i].shown == key || sources_->have(key)) continue;
    dropped |= records_.erase(bounces_.input(i).view) > 0;
  }
  if (dropped) bounces_ = asked(targets);

  for (std::size_t i = 0; i < entries.size(); ++i) {
    ProbeEntry& entry = entries[i];
    const Probe& probe = entries.probe(i);
    const std::string before = entry.wanted;
    if (bounces_.input(i).view.empty()) {
      entry.wanted.clear();
      continue;
    }
    if (probe.mode == ProbeMode::Realtime) {
      FaceKeys faces;
      for (std::size_t face = 0; face < 6; ++face) faces[face] = realtimeFace(probe, static_cast<int>(face));
      entry.wanted = realtime(probe, faces);
    } else {
      entry.wanted = bounces_.finalKey(i);
    }
    if (entry.wanted != before) entry.passes = bounces_.input(i).lighting.empty() ? 0 : probe.bounces - 1;
  }
}

// The first bounce shows no light from probes, so it differs from a later one only where a probe would throw some.
std::string ProbeKeys::face(std::size_t index, int bounce, int face) const {
  const Probe& probe = entries_->probe(index);
  if (!keepsCapture(probe)) return {};
  const CaptureView view = faceView(world_, probe, face);
  std::vector<std::string> lighting;
  for (const std::size_t other : bounces_.sees(index)) {
    if (!std::binary_search(view.lighting.begin(), view.lighting.end(), other)) continue;
    lighting.push_back(bounce > 1 ? bounces_.key(other, bounce - 1) : "none yet");
  }
  std::sort(lighting.begin(), lighting.end());
  ContentHash hash;
  hash.add(view.key);
  for (const std::string& key : lighting) hash.add(key);
  if (world_.lattices && bounce > 1 && !lighting.empty()) hash.add("by lattices");
  return hash.text();
}

std::string ProbeKeys::realtimeFace(const Probe& probe, int face) const {
  const CaptureView view = faceView(world_, probe, face);
  ContentHash hash;
  hash.add(view.key).add(probe.bounces > 1 ? (world_.lattices ? "lit by lattices" : "lit") : "dark");
  for (const std::size_t other : view.lighting) {
    if (probe.bounces > 1 && !bounces_.input(other).realtime) hash.add(bounces_.finalKey(other));
  }
  return hash.text();
}

std::string ProbeKeys::realtime(const Probe& probe, const FaceKeys& faces) {
  ContentHash hash;
  hash.add("realtime").add(static_cast<double>(probe.filter)).add(probe.filterSamples);
  for (const std::string& face : faces) hash.add(face);
  return hash.text();
}

void ProbeKeys::remember(std::size_t index) {
  if (entries_->baked(index)) records_[bounces_.input(index).view] = bounces_.record(index);
}

}  // namespace boxprobe
