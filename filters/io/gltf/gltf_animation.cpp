// Evaluates animations at one time (glTF 2.0, section 3.11 and appendix C).
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

/// The two keys around a time, and the position between them.
struct KeySpan {
  std::size_t from = 0, to = 0;
  double share = 0.0;
  double length = 0.0;  ///< seconds
};

KeySpan spanAt(const std::vector<float>& keys, double seconds) {
  KeySpan span;
  const auto next = std::upper_bound(keys.begin(), keys.end(), seconds,
                                     [](double time, float key) { return time < static_cast<double>(key); });
  if (next == keys.begin()) return span;
  span.from = span.to = static_cast<std::size_t>(next - keys.begin()) - 1;
  if (next == keys.end()) return span;
  span.to = span.from + 1;
  span.length = static_cast<double>(keys[span.to]) - static_cast<double>(keys[span.from]);
  if (span.length > 0.0) span.share = (seconds - static_cast<double>(keys[span.from])) / span.length;
  return span;
}

/// Slerp along the shorter arc.
std::vector<double> turnedBetween(const std::vector<double>& a, const std::vector<double>& b, double share) {
  const glm::dquat from(a[3], a[0], a[1], a[2]), to(b[3], b[0], b[1], b[2]);
  const glm::dquat q = glm::slerp(glm::normalize(from), glm::normalize(to), share);
  return {q.x, q.y, q.z, q.w};
}

/// A sampler's output: `size` numbers per key.
class Keys {
 public:
  Keys(const std::vector<float>& values, std::size_t size, bool cubic)
      : values_(values), size_(size), perKey_(cubic ? 3 : 1) {}

  /// `part`: 0 the incoming tangent, 1 the value, 2 the outgoing tangent; only cubic keys have tangents.
  std::vector<double> at(std::size_t key, std::size_t part = 1) const {
    const auto* first = values_.data() + (key * perKey_ + (perKey_ == 3 ? part : 0)) * size_;
    return {first, first + size_};
  }

 private:
  const std::vector<float>& values_;
  std::size_t size_, perKey_;
};

std::vector<double> interpolated(const Keys& keys, const KeySpan& span, const std::string& interpolation, bool turn) {
  const std::vector<double> a = keys.at(span.from), b = keys.at(span.to);
  if (span.from == span.to || interpolation == "STEP") return a;
  const double t = span.share;
  if (interpolation != "CUBICSPLINE") {
    if (turn) return turnedBetween(a, b, t);
    std::vector<double> mixed(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) mixed[i] = a[i] + t * (b[i] - a[i]);
    return mixed;
  }
  const std::vector<double> out = keys.at(span.from, 2), in = keys.at(span.to, 0);
  std::vector<double> value(a.size());
  const double t2 = t * t, t3 = t2 * t;
  for (std::size_t i = 0; i < a.size(); ++i) {
    value[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * a[i] + span.length * (t3 - 2.0 * t2 + t) * out[i] +
               (3.0 * t2 - 2.0 * t3) * b[i] + span.length * (t3 - t2) * in[i];
  }
  return value;
}

std::vector<double>* pathOf(GltfNodePose& pose, const std::string& path) {
  if (path == "translation") return &pose.translation;
  if (path == "rotation") return &pose.rotation;
  if (path == "scale") return &pose.scale;
  return path == "weights" ? &pose.weights : nullptr;
}

void applyChannel(GltfFile& file, const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel,
                  double seconds, const std::string& place, GltfPose& pose) {
  const int node = channel.target_node;
  if (node < 0 || static_cast<std::size_t>(node) >= file.gltf.nodes.size()) return;  // target of an extension
  std::vector<double>* target = pathOf(pose[static_cast<std::size_t>(node)], channel.target_path);
  if (target == nullptr || !target->empty()) return;
  if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= animation.samplers.size()) {
    file.fail(place, "sampler " + std::to_string(channel.sampler) + " does not exist; the file is damaged");
  }
  const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
  const bool turn = channel.target_path == "rotation", weights = channel.target_path == "weights";
  const std::vector<float> keys = readFloats(file, sampler.input, 1, place + ": input");
  const std::vector<float> values = readFloats(file, sampler.output, turn ? 4 : weights ? 1 : 3, place + ": output");
  const bool cubic = sampler.interpolation == "CUBICSPLINE";
  const std::size_t perKey = cubic ? 3 : 1;
  if (keys.empty() || !std::is_sorted(keys.begin(), keys.end())) {
    file.fail(place, "its times are missing or do not rise; repair the model");
  }
  const std::size_t size = turn ? 4 : weights ? values.size() / keys.size() / perKey : 3;
  if (size == 0 || values.size() < keys.size() * perKey * size) {
    file.fail(place, "has fewer values than times; repair the model");
  }
  *target = interpolated(Keys(values, size, cubic), spanAt(keys, seconds), sampler.interpolation, turn);
}

}  // namespace

GltfPose poseAt(GltfFile& file, double seconds) {
  GltfPose pose;
  for (std::size_t a = 0; a < file.gltf.animations.size(); ++a) {
    const tinygltf::Animation& animation = file.gltf.animations[a];
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
      const std::string place = "animation " + std::to_string(a) + ": channel " + std::to_string(c);
      applyChannel(file, animation, animation.channels[c], seconds, place, pose);
    }
  }
  return pose;
}

double animationSeconds(const GltfFile& file) {
  double end = 0.0;
  for (const tinygltf::Animation& animation : file.gltf.animations) {
    for (const tinygltf::AnimationSampler& sampler : animation.samplers) {
      if (sampler.input < 0 || static_cast<std::size_t>(sampler.input) >= file.gltf.accessors.size()) continue;
      // The specification requires the bounds of times.
      const std::vector<double>& last = file.gltf.accessors[static_cast<std::size_t>(sampler.input)].maxValues;
      if (last.size() == 1 && std::isfinite(last[0])) end = std::max(end, last[0]);
    }
  }
  return end;
}

}  // namespace boxprobe
