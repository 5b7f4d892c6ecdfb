// See review_page.h.
#include "app/web/review_page.h"

#include <algorithm>
#include <cstdio>
#include <variant>

#include "app/session/display_picture.h"
#include "app/session/program_name.h"
#include "app/web/base64.h"
#include "app/web/markup.h"
#include "app/web/page_policy.h"
#include "app/web/web_source.h"
#include "filters/core/scene/bounces.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string count(std::size_t number, const char* one, const char* more) {
  return std::to_string(number) + " " + (number == 1 ? one : more);
}

std::string degrees(double value) {
  return line("%.2f\u00b0", value);
}

std::string triple(const glm::dvec3& v) {
  return line("%.2f, %.2f, %.2f", v.x, v.y, v.z);
}

std::string mebibytes(std::size_t bytes) {
  return line("%.1f MiB", static_cast<double>(bytes) / (1024.0 * 1024.0));
}

std::string image(const ImageRgba8& picture, const std::string& alt, const char* kind) {
  return std::string("<img class=\"") + kind + "\" width=\"" + std::to_string(picture.width) + "\" height=\"" +
         std::to_string(picture.height) + "\" alt=\"" + alt + "\" src=\"data:image/png;base64," +
         base64(encodePng("report", picture)) + "\">";
}

std::string figure(const ImageRgba8& picture, const std::string& alt, const char* kind, const char* caption) {
  return std::string("<figure class=\"") + kind + "\">" + image(picture, alt, kind) + "<figcaption>" + caption +
         "</figcaption></figure>";
}

std::string cell(const std::string& text) {
  return "<td>" + text + "</td>";
}

/// The scale of the error maps, from the colours that they are made of.
std::string scaleHtml() {
  constexpr int kSteps = 8;
  std::string stops;
  for (int i = 0; i <= kSteps; ++i) {
    const auto bytes = differenceBytes(kMostDifference * i / kSteps);
    stops += line("%srgb(%d %d %d)", i == 0 ? "" : ",", bytes[0], bytes[1], bytes[2]);
  }
  return "<div class=\"scale\"><span>0</span><span class=\"bar\" style=\"background:linear-gradient(to right," + stops +
         ")\"></span><span>" + line("%.0f %% of white and more", 100.0 * kMostDifference) + "</span></div>";
}

std::string partsHtml(const std::vector<PartError>& parts) {
  std::string text =
      "<details><summary>By kind of surface</summary><div class=\"scroll\"><table><thead><tr><th scope=\"col\">Pixels "
      "that show</th><th scope=\"col\">Pixels</th><th scope=\"col\">Relative RMSE</th><th scope=\"col\">Light</th><th "
      "scope=\"col\">Noise</th></tr></thead><tbody>";
  for (const PartError& part : parts) {
    text += "<tr><th scope=\"row\">" + markup(part.part) + "</th>" + cell(std::to_string(part.pixels)) +
            cell(line("%.3f", part.relativeRmse)) + cell(line("%.2f", part.light)) + cell(line("%.3f", part.noise)) +
            "</tr>";
  }
  return text + "</tbody></table></div></details>";
}

std::string boxText(const Box& box) {
  return triple(box.min) + "<br>to " + triple(box.max);
}

std::string probeModeText(const Probe& probe) {
  switch (probe.mode) {
    case ProbeMode::Baked:
      return "baked";
    case ProbeMode::Realtime:
      return "realtime";
    case ProbeMode::Custom:
      break;
  }
  return "custom";
}

std::string probeHtml(const ReviewedProbe& row) {
  const Probe& probe = row.probe;
  const std::string fits = row.fit ? fitVerdict(*row.fit) : "not fitted: its capture comes from another place";
  const std::string bounces =
      allBounces(probe) ? "all bounces" : count(static_cast<std::size_t>(probe.bounces), "bounce", "bounces");
  std::string remarks;
  const bool stays = !row.fit || row.fit->outcome == FitOutcome::Kept;
  for (const Phrase& remark : !stays ? row.fit->remarks : std::vector<Phrase>()) {
    remarks += "<br>" + markup(remark.english());
  }
  return "<tr><th scope=\"row\">" + markup(probe.name) + "</th>" +
         cell(boxText(probe.box) + (probe.rotationDegrees == glm::dvec3(0.0)
                                        ? ""
                                        : "<br>turned by " + triple(probe.rotationDegrees) + "\u00b0")) +
         cell(triple(probe.origin)) + cell(markup(fits) + remarks) +
         cell(markup(probe.projection ? probe.technique : probe.technique + ", projection off")) +
         cell(probeModeText(probe) + ", " + line("%d\u00b2 texels a face, ", probe.faceSize) + bounces + "<br>" +
              mebibytes(row.bytes) + ", lights " + count(row.objects, "object", "objects")) +
         "</tr>\n";
}

std::string probesHtml(const SceneReview& review) {
  if (review.probes.empty()) return "<p>No probe: the surroundings alone are reflected.</p>\n";
  std::string text =
      "<div class=\"scroll\"><table class=\"probes\"><thead><tr><th scope=\"col\">Probe</th><th "
      "scope=\"col\">Box</th><th "
      "scope=\"col\">Capture origin</th><th scope=\"col\">Fit</th><th scope=\"col\">Technique</th><th "
      "scope=\"col\">Cost</th></tr></thead><tbody>\n";
  for (const ReviewedProbe& row : review.probes) text += probeHtml(row);
  return text + "</tbody></table></div>\n<p>" +
         line("%llu faces captured and filtered", static_cast<unsigned long long>(review.faces)) +
         (review.captureCpuSeconds ? line(" in %.1f s of CPU time", *review.captureCpuSeconds) : "") + ".</p>\n";
}

std::string skyText(const Sky& sky) {
  if (std::holds_alternative<SkyColor>(sky)) return "one colour";
  if (const auto* image = std::get_if<SkyImage>(&sky)) {
    return "picture " + markup(image->file.substr(image->file.find_last_of('/') + 1));
  }
  return "gradient";
}

std::string lightsText(const Scene& scene) {
  std::size_t kinds[3] = {0, 0, 0};
  for (const Light& light : scene.lights) ++kinds[static_cast<std::size_t>(light.type)];
  const char* const names[] = {"directional", "point", "spot"};
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    if (kinds[i] > 0) text += (text.empty() ? "" : ", ") + std::to_string(kinds[i]) + " " + names[i];
  }
  return text.empty() ? "none" : text;
}

std::string settingsHtml(const SceneReview& review, const ReviewSettings& settings) {
  const Scene& scene = review.scene;
  std::string models;
  for (const ModelFile& model : scene.models) {
    models += (models.empty() ? "" : ", ") + markup(model.file.substr(model.file.find_last_of('/') + 1));
    if (!model.variant.empty()) models += ", variant " + markup(model.variant);
  }
  const char* const tones[] = {"none", "neutral", "agx", "aces", "as VTK"};
  const std::vector<std::pair<const char*, std::string>> rows = {
      {"Models", models + ", " + count(review.triangles, "triangle", "triangles")},
      {"Sky",
       skyText(scene.sky) +
           (scene.skyRotationDegrees == 0.0 ? std::string() : line(", turned by %g\u00b0", scene.skyRotationDegrees))},
      {"Lights", lightsText(scene)},
      {"Exposure", line("%.4g", scene.exposure)},
      {"Tone mapping", tones[static_cast<std::size_t>(scene.tone)]},
      {"Lamps", scene.lamps == LampForm::Shapes ? "shapes" : "in-map"},
      {"Energy", scene.energy == Energy::Single ? "single" : "multiple"},
      {"Ambient occlusion", scene.ambientOcclusion ? "on" : "off"},
      {"Drawn", line("%d x %d, %d samples per pixel, ", settings.width, settings.height, settings.samplesPerPixel) +
                    markup(review.rendererName)},
      {"Path traced", line("%d paths per pixel, all bounces, seed %llu", settings.paths,
                           static_cast<unsigned long long>(settings.seed))}};
  std::string text = "<dl>";
  for (const auto& [name, value] : rows) text += std::string("<dt>") + name + "</dt><dd>" + value + "</dd>";
  return text + "</dl>\n";
}

}  // namespace

std::string fitVerdict(const BoxFit& fit) {
  const double before = fit.before.meanDegrees, after = fit.after.meanDegrees;
  switch (fit.outcome) {
    case FitOutcome::Open:
      return "open: there are no walls to fit to";
    case FitOutcome::Inside:
      return "the capture origin is inside a wall";
    case FitOutcome::Fitted:
      if (degrees(before) != degrees(after)) {
        return "a better box exists: mean error " + degrees(before) + " \u2192 " + degrees(after);
      }
      break;
    case FitOutcome::Kept:
      break;
  }
  return "fits: mean error " + degrees(before);
}

bool tooNoisy(const PartError& error) {
  return error.noise > 0.01 && error.noise > error.relativeRmse;
}

void ReviewPage::add(const SceneReview& review) {
  const std::string scene = markup(review.name);
  const std::string id = "scene" + std::to_string(++scenes_);
  names_ += (names_.empty() ? "" : ", ") + scene;
  sections_ += "<section id=\"" + id + "\"><h2>" + scene + "</h2>\n";
  for (const ReviewedCamera& row : review.cameras) {
    const std::string name = markup(row.camera.name);
    const std::string link = id + "-camera" + std::to_string(++cameras_);
    const PartError& all = row.all();
    const bool fails = settings_.failAbove && !(all.relativeRmse <= *settings_.failAbove);
    failed_ += fails ? 1 : 0;
    const std::string state =
        !settings_.failAbove ? std::string() : cell(fails ? "<b class=\"bad\">above</b>" : "below");
    rows_ += "<tr><th scope=\"row\"><a href=\"#" + link + "\">" + scene + ", " + name + "</a></th>" +
             cell(line("%.3f", all.relativeRmse)) + cell(line("%.2f", all.light)) + cell(line("%.3f", all.noise)) +
             state + "</tr>\n";
    const bool noisy = tooNoisy(all);
    const ImageRgba8 drawn = displayPicture(row.picture, review.scene.exposure, review.scene.tone);
    const ImageRgba8 traced = displayPicture(row.truth.color, review.scene.exposure, review.scene.tone);
    const std::string from = scene + " from camera " + name;
    sections_ += "<article id=\"" + link + "\"><h3>" + name + "</h3>\n<p class=\"numbers\"><b>" +
                 line("Relative RMSE %.3f", all.relativeRmse) +
                 (fails ? " <span class=\"bad\">above the limit</span>" : "") + "</b>" +
                 line("; light %.2f of the traced picture's; its noise %.3f; %.2f cubemap samples per pixel", all.light,
                      all.noise, row.lookups.mean) +
                 (noisy ? "; <b class=\"bad\">the noise hides the error: trace more paths (--rays)</b>" : "") +
                 "</p>\n<div class=\"pair\">" + figure(drawn, from + ", drawn", "drawn", "drawn") +
                 figure(traced, from + ", path traced", "traced", "path traced") + "</div>\n" +
                 figure(differencePicture(drawn, traced), "Differences of " + from, "map", "error map") + scaleHtml() +
                 partsHtml(row.parts) + "</article>\n";
  }
  sections_ +=
      "<h3>Probes</h3>\n" + probesHtml(review) + "<h3>Settings</h3>\n" + settingsHtml(review, settings_.review);
  if (!review.remarks.empty()) {
    sections_ += "<h3>Remarks</h3>\n<ul>";
    for (const std::string& remark : review.remarks) sections_ += "<li>" + markup(remark) + "</li>";
    sections_ += "</ul>\n";
  }
  sections_ += "</section>\n";
}

std::string ReviewPage::text() const {
  std::string verdict;
  if (settings_.failAbove) {
    const std::string limit = line("%g", *settings_.failAbove);
    verdict = failed_ == 0 ? "<p class=\"verdict good\">Passed: no camera's error is above " + limit + ".</p>\n"
                           : "<p class=\"verdict bad\">Failed: the error of " + std::to_string(failed_) + " of " +
                                 count(cameras_, "camera", "cameras") + " is above " + limit + ".</p>\n";
  }
  const std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Report: " +
      names_ + "</title>\n<style>\n" + std::string(webSource("review.css")) +
      "</style></head><body>\n<main>\n<h1>Report: " + names_ + "</h1>\n" + verdict +
      "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">Camera</th><th scope=\"col\">Relative RMSE</th><th "
      "scope=\"col\">Light</th><th scope=\"col\">Noise</th>" +
      (settings_.failAbove ? "<th scope=\"col\">Limit</th>" : "") + "</tr></thead><tbody>\n" + rows_ +
      "</tbody></table></div>\n<p class=\"dim\">Relative RMSE: the root of the summed squared differences from the "
      "path-traced picture divided by that picture's summed squares, in linear light, with the path tracer's noise "
      "subtracted; 0 means equal. Light: the drawn picture's mean divided by the traced one's. Error maps show "
      "display colours.</p>\n" +
      sections_ + "</main>\n<footer><p>" + kProgramName + "</p><pre><code>" + markup(settings_.command) +
      "</code></pre></footer>\n<script>\n" + std::string(webSource("review.js")) + "</script></body></html>\n";
  return withPolicy(page, {"", "", "img-src data:; style-src-attr 'unsafe-inline'; "});
}

}  // namespace boxprobe
