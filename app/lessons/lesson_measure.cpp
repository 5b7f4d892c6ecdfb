// See lesson_measure.h.
#include "app/lessons/lesson_measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>

#include "app/lessons/fit_measure.h"
#include "app/session/explanation_json.h"
#include "app/session/load_scene.h"
#include "app/session/reference_box_picture.h"
#include "filters/core/scene/surface_view.h"
#include "filters/explain/surface_value.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/scene_file.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/measure/metrics.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kGridColumns = 32, kGridRows = 20;  // places a view's mean is taken over
constexpr int kSamples = 4;                       // a pixel
constexpr int kTruthRays = 64;                    // a pixel, over its samples

PicturePart pixelsOf(const PictureRegion& region, int width, int height) {
  const auto at = [](double share, int size) { return static_cast<int>(std::lround(share * size)); };
  PicturePart range{at(region[0], width), at(region[1], height), at(region[2], width), at(region[3], height)};
  range.left = std::min(range.left, width - 1);
  range.top = std::min(range.top, height - 1);
  range.right = std::max(range.right, range.left + 1);
  range.bottom = std::max(range.bottom, range.top + 1);
  return range;
}

std::vector<bool> maskOf(const PictureRegion& region, int width, int height) {
  const PicturePart range = pixelsOf(region, width, height);
  std::vector<bool> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = range.top; y < range.bottom; ++y) {
    for (int x = range.left; x < range.right; ++x) {
      mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = true;
    }
  }
  return mask;
}

glm::ivec2 pixelAt(const PicturePoint& point, int width, int height) {
  return {std::min(static_cast<int>(point[0] * width), width - 1),
          std::min(static_cast<int>(point[1] * height), height - 1)};
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> numberIn(const std::string& json, const std::string& pointer) {
  try {
    const Json root = Json::parse(json);
    const Json::json_pointer at(pointer);
    if (!root.contains(at) || !root.at(at).is_number()) return std::nullopt;
    return root.at(at).get<double>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

double meanLight(const ImageRgbaF& picture, const LessonMeasure& measure) {
  const std::vector<bool> mask = maskOf(measure.region, picture.width, picture.height);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const float* pixel = &picture.pixels[4 * i];
    sum += measure.channel >= 0 ? static_cast<double>(pixel[measure.channel])
                                : (static_cast<double>(pixel[0]) + pixel[1] + pixel[2]) / 3.0;
    ++count;
  }
  return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

ReferenceProgress whileGoingOn(const ShownScene& shown) {
  return [&shown](double) { return !shown.goOn || shown.goOn(); };
}

double errorAgainstScene(const ShownScene& shown, const ImageRgbaF& picture, const PictureRegion& region) {
  ReferenceSettings settings;
  settings.width = picture.width;
  settings.height = picture.height;
  settings.samplesPerPixel = kSamples;
  settings.raysPerPixel = kTruthRays;
  settings.part = pixelsOf(region, picture.width, picture.height);
  const SceneOfDrawnSky drawn = withDrawnSky(shown.scene);
  const ReferenceScene scene(drawn.scene, shown.models, drawn.skyImage);
  const ImageRgbaF truth = scene.render(shown.camera, settings, whileGoingOn(shown)).color;
  return pictureDifference(picture, truth, region);
}

double errorAgainstBox(const ShownScene& shown, const PictureRegion& region) {
  const BoxPictureSize size{shown.width, shown.height, 1, kTruthRays, pixelsOf(region, shown.width, shown.height)};
  const ImageRgbaF truth =
      integrateBox(shown.renderer, boxMaps(shown.renderer, shown.scene), size, whileGoingOn(shown)).color;
  return pictureDifference(shown.renderer.renderLinear(shown.width, shown.height, 1), truth, region);
}

/// Pixels spread evenly over a region.
std::vector<glm::ivec2> gridOver(const PictureRegion& r, const ShownScene& shown) {
  std::vector<glm::ivec2> places;
  for (int row = 0; row < kGridRows; ++row) {
    for (int column = 0; column < kGridColumns; ++column) {
      const double x = (column + 0.5) / kGridColumns, y = (row + 0.5) / kGridRows;
      places.push_back(pixelAt({r[0] + x * (r[2] - r[0]), r[1] + y * (r[3] - r[1])}, shown.width, shown.height));
    }
  }
  return places;
}

/// Where a view or a number of explanations is asked for.
std::vector<glm::ivec2> placesOf(const ShownScene& shown, const LessonMeasure& measure) {
  if (measure.points.empty()) return gridOver(measure.region, shown);
  return {pixelAt(measure.points.front(), shown.width, shown.height)};
}

std::optional<double> viewMean(const ShownScene& shown, const LessonMeasure& measure) {
  const auto view = findSurfaceView(measure.name);
  if (!view) return std::nullopt;
  double sum = 0.0;
  int count = 0;
  for (const Explanation& e : shown.renderer.explain(placesOf(shown, measure), shown.width, shown.height)) {
    const auto value = surfaceValue(surfaceViews()[static_cast<std::size_t>(*view)], e);
    if (!value || !std::isfinite(value->x)) continue;
    sum += value->x;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// A number of explanations; of a region the mean where there is one.
std::optional<double> explained(const ShownScene& shown, const LessonMeasure& measure) {
  double sum = 0.0;
  int count = 0;
  for (const Explanation& e : shown.renderer.explain(placesOf(shown, measure), shown.width, shown.height)) {
    const auto value = numberIn(explanationJson(e), measure.name);
    if (!value) continue;
    sum += *value;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// What of the box a lookup shows, relative to the capture origin: where a ray from there in its direction leaves it.
std::optional<glm::dvec3> shownOfBox(const Explanation& e) {
  if (!e.hit || e.dominant < 0) return std::nullopt;
  const ProbeExplanation& probe = e.probes[static_cast<std::size_t>(e.dominant)];
  const glm::dvec3 direction(probe.lookupDirection);
  double factor = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    if (d == 0.0) continue;
    factor = std::min(factor, (d > 0.0 ? static_cast<double>(probe.boxMax[axis]) : probe.boxMin[axis]) / d);
  }
  if (!std::isfinite(factor) || factor < 0.0) return std::nullopt;
  return factor * direction;
}

std::optional<double> bend(const ShownScene& shown, const std::vector<PicturePoint>& points) {
  std::vector<glm::dvec3> seen;
  for (const PicturePoint& point : points) {
    const glm::ivec2 pixel = pixelAt(point, shown.width, shown.height);
    const auto place = shownOfBox(shown.renderer.explain(pixel.x, pixel.y, shown.width, shown.height));
    if (!place) return std::nullopt;
    seen.push_back(*place);
  }
  const glm::dvec3 along = seen[2] - seen[0];
  const double length = glm::length(along);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec3 unit = along / length;
  const glm::dvec3 offset = seen[1] - seen[0];
  return glm::length(offset - glm::dot(offset, unit) * unit) / length;
}

ImageRgbaF pictureOf(const ShownScene& shown) {
  return shown.picture != nullptr ? *shown.picture : shown.renderer.renderLinear(shown.width, shown.height, kSamples);
}

/// The largest component of a difference between a pixel and the one beside or below it.
double largestJump(const ImageRgbaF& picture, const PictureRegion& region) {
  const PicturePart part = pixelsOf(region, picture.width, picture.height);
  const auto at = [&](int x, int y, int c) {
    const auto pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
    return toneMapped(static_cast<double>(picture.pixels[4 * pixel + static_cast<std::size_t>(c)]));
  };
  double largest = 0.0;
  for (int y = part.top; y < part.bottom; ++y) {
    for (int x = part.left; x < part.right; ++x) {
      for (int c = 0; c < 3; ++c) {
        if (x + 1 < part.right) largest = std::max(largest, std::abs(at(x + 1, y, c) - at(x, y, c)));
        if (y + 1 < part.bottom) largest = std::max(largest, std::abs(at(x, y + 1, c) - at(x, y, c)));
      }
    }
  }
  return largest;
}

std::optional<double> measureHere(const ShownScene& shown, const LessonMeasure& measure) {
  switch (measure.kind) {
    case MeasureKind::Error:
      if (measure.box) return errorAgainstBox(shown, measure.region);
      return errorAgainstScene(shown, pictureOf(shown), measure.region);
    case MeasureKind::Mean:
      return finite(meanLight(pictureOf(shown), measure));
    case MeasureKind::Jump:
      return finite(largestJump(pictureOf(shown), measure.region));
    case MeasureKind::Explain:
      return explained(shown, measure);
    case MeasureKind::Fit:
      return fitNumber(shown.scene, shown.models, measure.name, shown.goOn);
    case MeasureKind::View:
      return viewMean(shown, measure);
    case MeasureKind::Bend:
      return bend(shown, measure.points);
    case MeasureKind::Field:
      return sceneNumber(shown.scene, measure.name);
    case MeasureKind::Difference:
    case MeasureKind::Counter:
    case MeasureKind::Broken:
    case MeasureKind::Turned:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> measureShown(const ShownScene& shown, const LessonMeasure& measure) {
  if (measure.kind == MeasureKind::Field) return measureHere(shown, measure);
  const Camera kept = shown.renderer.currentCamera();
  const SurfaceViewSettings view = shown.renderer.view();
  shown.renderer.applyCamera(shown.camera);
  shown.renderer.setView({});  // light is measured, whatever colours the step shows
  const auto value = measureHere(shown, measure);
  shown.renderer.setView(view);
  shown.renderer.applyCamera(kept);
  return value;
}

std::vector<Explanation> explanationsOf(const ShownScene& shown, const LessonMeasure& measure) {
  const Camera kept = shown.renderer.currentCamera();
  shown.renderer.applyCamera(shown.camera);
  std::vector<Explanation> found = shown.renderer.explain(placesOf(shown, measure), shown.width, shown.height);
  shown.renderer.applyCamera(kept);
  return found;
}

double pictureDifference(const ImageRgbaF& picture, const ImageRgbaF& other, const PictureRegion& region) {
  return pictureError(picture, other, maskOf(region, picture.width, picture.height)).toneMappedRmse;
}

std::string measuredText(double value, const std::string& unit) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.3g", value);
  if (unit.empty()) return text;
  return text + std::string(unit == "\u00b0" ? "" : " ") + unit;
}

double conditionLimit(const LessonCondition& condition, double times) {
  return condition.times ? condition.limit * times : condition.limit;
}

bool conditionHolds(const LessonCondition& condition, double value, double times) {
  const double limit = conditionLimit(condition, times);
  switch (condition.comparison) {
    case Comparison::Above:
      return value > limit;
    case Comparison::Below:
      return value < limit;
    case Comparison::Within:
      return std::abs(value - limit) <= condition.tolerance;
  }
  return false;
}

}  // namespace boxprobe
