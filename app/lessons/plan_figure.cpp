// See plan_figure.h.
#include "app/lessons/plan_figure.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "filters/core/base/fixed_text.h"
#include "filters/explain/schematic.h"

namespace boxprobe {

namespace {

// As data/web/plan.js has them: pixels of the drawing's own.
constexpr double kPlanWidth = 420.0, kPlanMargin = 34.0, kPlanTallest = 360.0;

const ProbeExplanation& shownProbe(const Explanation& e) {
  return e.probes[static_cast<std::size_t>(std::max(e.dominant, 0))];
}

nlohmann::ordered_json triple(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

const char* classOf(SchematicLine kind) {
  switch (kind) {
    case SchematicLine::Eye:
      return "view";
    case SchematicLine::Normal:
      return "normal";
    case SchematicLine::Reflected:
      return "reflected";
    case SchematicLine::Lookup:
      return "lookup";
    case SchematicLine::TrueHit:
      return "truth";
    case SchematicLine::Slab:
      return "beyond";
  }
  return "";
}

/// One drawing, its units pixels.
class StillView {
 public:
  explicit StillView(const SchematicView& view) : view_(view) {
    glm::dvec2 low = view.low, high = view.high;
    for (const SchematicView::Point& point : view.points) {  // the eye too, which the window may leave out
      low = glm::min(low, point.at);
      high = glm::max(high, point.at);
    }
    const glm::dvec2 size = glm::max(high - low, glm::dvec2(1e-6));
    scale_ = std::min((kPlanWidth - 2.0 * kPlanMargin) / size.x, (kPlanTallest - 2.0 * kPlanMargin) / size.y);
    height_ = scale_ * size.y + 2.0 * kPlanMargin;
    left_ = 0.5 * (kPlanWidth - scale_ * size.x) - scale_ * low.x;
    bottom_ = height_ - kPlanMargin + scale_ * low.y;
  }

  std::string svg() const {
    std::string text = "<figure class=\"plan-view\"><svg viewBox=\"0 0 " + number(kPlanWidth) + " " + number(height_) +
                       "\" role=\"img\" aria-label=\"" + view_.title.english() + "\">";
    if (view_.boxLow) {
      const glm::dvec2 a = pixel({view_.boxLow->x, view_.boxHigh->y}), b = pixel({view_.boxHigh->x, view_.boxLow->y});
      text += "<rect class=\"box\" x=\"" + number(a.x) + "\" y=\"" + number(a.y) + "\" width=\"" + number(b.x - a.x) +
              "\" height=\"" + number(b.y - a.y) + "\"/>";
    }
    for (const SchematicView::Line& line : view_.lines) {
      const glm::dvec2 a = pixel(line.from), b = pixel(line.to);
      text += std::string("<line class=\"") + classOf(line.kind) + "\" x1=\"" + number(a.x) + "\" y1=\"" + number(a.y) +
              "\" x2=\"" + number(b.x) + "\" y2=\"" + number(b.y) + "\"/>";
      if (!line.label.empty()) text += label(0.5 * (a + b) + glm::dvec2(6.0, -6.0), line.label, classOf(line.kind));
    }
    for (const SchematicView::Point& point : view_.points) {
      const glm::dvec2 at = pixel(point.at);
      const bool plane = point.kind == SchematicPoint::SlabPlane;
      const std::string name = plane ? "crossing" : point.kind == SchematicPoint::Hit ? "hit" : "dot";
      text += "<circle class=\"" + name + "\" cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"4\"/>";
      text += label(at + 13.0 * glm::dvec2(point.labelDirection.x, -point.labelDirection.y) + glm::dvec2(-5.0, 5.0),
                    point.label.english(), plane ? "beyond" : name);
    }
    return text + "</svg><figcaption>" + view_.title.english() + "</figcaption></figure>";
  }

 private:
  glm::dvec2 pixel(const glm::dvec2& p) const { return {left_ + scale_ * p.x, bottom_ - scale_ * p.y}; }
  static std::string number(double value) { return fixedText(value, 1); }
  static std::string label(const glm::dvec2& at, const std::string& text, const std::string& name) {
    if (text.empty()) return {};
    return "<text class=\"" + name + "\" x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\">" + text + "</text>";
  }

  const SchematicView& view_;
  double scale_ = 1.0, height_ = 0.0, left_ = 0.0, bottom_ = 0.0;
};

}  // namespace

bool hasPlan(const Explanation& e) {
  return e.hit && !e.probes.empty() && shownProbe(e).slabFactors.has_value() &&
         e.surface.normalWorld != glm::vec3(0.0f);
}

std::string planJson(const Explanation& e) {
  const ProbeExplanation& p = shownProbe(e);
  const glm::dmat3 boxFromWorld = glm::transpose(glm::dmat3(p.worldFromProbe));
  const glm::dvec3 origin = boxFromWorld * p.originWorld;
  const glm::dvec3 along = glm::abs(glm::dvec3(p.reflectionProbe));
  const nlohmann::ordered_json json = {
      {"position", triple(boxFromWorld * e.surface.positionWorld)},
      {"normal", triple(boxFromWorld * glm::dvec3(e.surface.normalWorld))},
      {"eye", triple(boxFromWorld * e.surface.eyeWorld)},
      {"origin", triple(origin)},
      {"box", {{"min", triple(origin + glm::dvec3(p.boxMin))}, {"max", triple(origin + glm::dvec3(p.boxMax))}}},
      {"elevation", along.x >= along.z ? "front" : "side"}};
  return json.dump();
}

std::string planSvg(const Explanation& e) {
  const auto drawn = schematic(e);
  if (!drawn) return {};
  return StillView(drawn->plan).svg() + StillView(drawn->elevation).svg();
}

}  // namespace boxprobe
