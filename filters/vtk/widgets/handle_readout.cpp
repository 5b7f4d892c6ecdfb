#include "filters/vtk/widgets/handle_readout.h"

#include <charconv>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

namespace {

/// Independent of the locale.
std::string decimals(double value, int count) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, count).ptr;
  return {buffer, end};
}

std::string filled(const ReadoutStyle& style, const char* form, const std::vector<std::string>& values) {
  std::string text = style.words ? style.words(form) : form;
  int number = 0;
  for (const std::string& value : values) {
    const std::string mark = "%" + std::to_string(++number);
    const std::size_t at = text.find(mark);
    if (at != std::string::npos) text.replace(at, mark.size(), value);
  }
  return text;
}

/// The unit is the last value, wherever a translation puts it.
std::string withUnit(const ReadoutStyle& style, const char* form, std::vector<std::string> values) {
  values.push_back(style.unit);
  std::string text = filled(style, form, values);
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string length(double value) {
  return decimals(value, 3);
}

std::string sizeText(const ReadoutStyle& style, const Box& box) {
  const glm::dvec3 size = box.size();
  return withUnit(style, "size %1 × %2 × %3 %4", {length(size.x), length(size.y), length(size.z)});
}

double sideOf(const Box& box, const BoxFace& face) {
  return face.positive ? box.max[face.axis] : box.min[face.axis];
}

}  // namespace

std::string handleReadout(const Handle& handle, const Probe& before, const Probe& now, const ReadoutStyle& style) {
  const std::string face = faceName(handle.face);
  const auto say = [&style](const char* form, std::vector<std::string> values) {
    return withUnit(style, form, std::move(values));
  };
  switch (handle.kind) {
    case HandleKind::Face:
      return say("%1  %2 %3", {face, length(sideOf(now.box, handle.face))}) + "\n" + sizeText(style, now.box);
    case HandleKind::Influence:
      return say("influence %1  %2 %3", {face, length(sideOf(now.influenceBox(), handle.face))}) + "\n" +
             sizeText(style, now.influenceBox());
    case HandleKind::Blend: {
      const glm::dvec3& distances = handle.face.positive ? now.blendDistance.max : now.blendDistance.min;
      return say("blend %1  %2 %3", {face, length(distances[handle.face.axis])});
    }
    case HandleKind::Move:
      return say("moved by %1 %2", {length(glm::length(now.origin - before.origin))});
    case HandleKind::Turn: {
      const glm::dvec3& r = now.rotationDegrees;
      return filled(style, "rotation\n%1°  %2°  %3°", {decimals(r.x, 1), decimals(r.y, 1), decimals(r.z, 1)});
    }
    case HandleKind::Origin:
    case HandleKind::OriginAxis:
      break;
  }
  return say("origin\n%1  %2  %3 %4", {length(now.origin.x), length(now.origin.y), length(now.origin.z)});
}

std::string snapReadout(const DragSnap& snap, const Handle& handle, const ReadoutStyle& style) {
  char buffer[64];
  const auto number = [&buffer](double value) {
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, 6).ptr;
    return std::string(buffer, end);
  };
  if (handle.kind == HandleKind::Turn) return filled(style, "steps of %1°", {number(snap.turnStepDegrees())});
  if (snap.target() == SnapTarget::Pointed) return filled(style, "on the wall under the pointer", {});
  if (snap.target() == SnapTarget::Opposite) return filled(style, "on the wall ahead", {});
  return withUnit(style, "grid %1 %2", {number(snap.gridStep())});
}

}  // namespace boxprobe
