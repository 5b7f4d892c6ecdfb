#include "filters/vtk/probes/bounce_keys.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

using Views = std::unordered_set<std::string_view>;

Views viewsOf(const std::vector<std::string>& views) {
  return {views.begin(), views.end()};
}

}  // namespace

BounceKeys::BounceKeys(std::vector<Input> inputs) : inputs_(std::move(inputs)) {
  int most = 1;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    Input& input = inputs_[i];
    if (input.imported || input.realtime) input.bounces = 1;
    most = std::max(most, input.bounces);
    std::vector<std::size_t> sees;
    const Views known = input.record ? viewsOf(input.record->known) : Views();
    const Views seen = input.record ? viewsOf(input.record->sees) : Views();
    for (std::size_t other = 0; other < inputs_.size() && !input.view.empty(); ++other) {
      if (inputs_[other].realtime || inputs_[other].view.empty()) continue;
      const bool lights = std::find(input.lighting.begin(), input.lighting.end(), other) != input.lighting.end();
      const std::string& view = inputs_[other].view;
      if (known.count(view) != 0 ? seen.count(view) != 0 : lights) sees.push_back(other);
    }
    sees_.push_back(std::move(sees));
    keys_.push_back({input.view});
  }
  for (int bounce = 2; bounce <= most; ++bounce) {
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (bounce > inputs_[i].bounces) continue;
      // In the order of the keys: the order of the list of probes is nothing a picture shows.
      std::vector<std::string> shown;
      for (const std::size_t other : sees_[i]) shown.push_back(key(other, bounce - 1));
      std::sort(shown.begin(), shown.end());
      ContentHash hash;
      hash.add(inputs_[i].view).add(inputs_[i].lattices ? "lit by lattices" : "lit by");
      for (const std::string& text : shown) hash.add(text);
      keys_[i].push_back(shown.empty() ? inputs_[i].view : hash.text());
    }
  }
}

const std::string& BounceKeys::key(std::size_t probe, int bounce) const {
  const auto& keys = keys_[probe];
  return keys[std::min(static_cast<std::size_t>(bounce), keys.size()) - 1];
}

BakeRecord BounceKeys::record(std::size_t probe) const {
  BakeRecord record{finalKey(probe), inputs_[probe].view, {}, {}};
  // A single bounce shows no other probe; that the list grows with their number is for those that do.
  if (inputs_[probe].bounces < 2) return record;
  for (const std::size_t other : sees_[probe]) record.sees.push_back(inputs_[other].view);
  for (const Input& other : inputs_) {
    if (!other.view.empty()) record.known.push_back(other.view);
  }
  return record;
}

}  // namespace boxprobe
