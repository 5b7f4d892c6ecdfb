// See report_text.h.
#include "app/cli/report/report_text.h"

#include <cstdio>

#include "filters/core/base/printable_text.h"

namespace boxprobe {

namespace {

using Json = nlohmann::ordered_json;

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string vector3(const Json& v) {
  return "(" + numberText(v[0].get<double>()) + ", " + numberText(v[1].get<double>()) + ", " +
         numberText(v[2].get<double>()) + ")";
}

std::string box(const Json& b) {
  return vector3(b["min"]) + " to " + vector3(b["max"]);
}

std::string mebibytes(const Json& bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f MiB", bytes.get<double>() / (1024.0 * 1024.0));
  return text;
}

/// Names may hold line ends.
std::string word(const Json& value) {
  return value.is_string() ? printable(value.get<std::string>()) : value.dump();
}

std::string listOf(const Json& names) {
  std::string list;
  for (const Json& name : names) list += (list.empty() ? "" : ", ") + word(name);
  return list;
}

std::string modelLine(const Json& m) {
  const std::string materials = listOf(m["materials"]);
  const std::string unit = m["unit"] == "m" ? "" : " in " + word(m["unit"]);
  return word(m["file"]) + unit + ": " + word(m["meshes"]) + " meshes, " + word(m["triangles"]) + " triangles (" +
         mebibytes(m["arrayBytes"]) + "), " + word(m["textures"]) + " textures (" + mebibytes(m["textureBytes"]) +
         ")\n    materials: " + (materials.empty() ? "none" : materials) +
         (m.contains("variants") ? "\n    variants: " + listOf(m["variants"]) : "") +
         (m.contains("animationSeconds") ? "\n    animations: " + word(m["animationSeconds"]) + " s" : "");
}

std::string objectLine(const Json& o) {
  std::string line = word(o["name"]);
  if (!o["visible"].get<bool>()) line += ", not visible";
  if (!o["seenByProbes"].get<bool>()) line += ", not seen by probes";
  if (o["dynamic"].get<bool>()) line += ", dynamic";
  if (o["probeMode"] != "blend+sky") line += ", probes: " + word(o["probeMode"]);
  if (o["weights"] != "pixel") line += ", weights by " + word(o["weights"]);
  return line;
}

std::string probeLine(const Json& p) {
  std::string line = word(p["name"]) + ": technique " + word(p["technique"]) +
                     (p["projection"].get<bool>() ? "" : " (projection off)") + ", " + word(p["faceSize"]) +
                     " texels a face, " + word(p["bounces"]) + " bounce" + (p["bounces"] == 1 ? "" : "s") + ", " +
                     mebibytes(p["textureBytes"]) + "\n    origin " + vector3(p["origin"]) + ", box " + box(p["box"]);
  line += "\n    diffuse light: " + word(p["diffuseLight"]);
  if (p.contains("image")) {
    line += "\n    picture " + word(p["image"]);
    const std::string layout = p.contains("imageLayout") ? word(p["imageLayout"]) : "";
    if (!layout.empty()) line += ", " + layout;
    if (!layout.empty() && layout != "latlong") line += " seen from " + word(p["cubeView"]);
    if (p.contains("imageRotationDegrees")) line += ", turned by " + word(p["imageRotationDegrees"]) + " degrees";
  }
  if (p["influence"] != p["box"]) line += "\n    influence " + box(p["influence"]);
  return line;
}

std::string lightLine(const Json& l) {
  const bool directional = l["type"] == "directional";
  return word(l["type"]) + (directional ? ", direction " + vector3(l["direction"]) : ", at " + vector3(l["position"])) +
         ", colour " + vector3(l["color"]) + ", intensity " + numberText(l["intensity"].get<double>());
}

std::string skyLine(const Json& sky) {
  if (sky["kind"] == "color") return "colour " + vector3(sky["color"]);
  if (sky["kind"] == "image") {
    std::string line = word(sky["file"]) + ", " + word(sky["width"]) + " x " + word(sky["height"]);
    if (sky.contains("cubeView")) line += ", a " + word(sky["layout"]) + " seen from " + word(sky["cubeView"]);
    if (sky.contains("rotationDegrees")) line += ", turned by " + word(sky["rotationDegrees"]) + " degrees";
    if (!sky.contains("sunLight")) return line;
    const Json& sun = sky["sunLight"];
    return line + "\n  its sun was taken out and is drawn as a light: " + lightLine(sun) + ", " +
           numberText(sun["angleDegrees"].get<double>()) + " degrees wide";
  }
  return "top " + vector3(sky["top"]) + ", horizon " + vector3(sky["horizon"]) + ", ground " + vector3(sky["ground"]);
}

std::string cameraLine(const Json& c) {
  return word(c["name"]) + ": at " + vector3(c["position"]) + ", towards " + vector3(c["target"]) + ", " +
         numberText(c["verticalFovDegrees"].get<double>()) + " degrees high";
}

std::string lampLine(const Json& l) {
  const bool one = l["polygons"] == 1;
  return word(l["object"]) + ": " + word(l["polygons"]) + (one ? " polygon" : " polygons") + ", radiance " +
         vector3(l["radiance"]) + ", power " + numberText(l["power"].get<double>());
}

template <class Line>
std::string section(const std::string& title, const Json& things, Line line) {
  std::string text = title + " (" + std::to_string(things.size()) + ")\n";
  for (const Json& thing : things) text += "  " + line(thing) + "\n";
  return text;
}

/// A bare model's kind and exposure; empty for a scene file.
std::string fitText(const Json& report) {
  if (!report.contains("fit")) return {};
  const Json& fit = report["fit"];
  const bool open = fit["exposure"] == "automatic";
  return "kind\n  " + word(fit["decided"]) + "\n  exposure " +
         (open ? "automatic: known once a frame is drawn (--frame)" : numberText(report["exposure"].get<double>())) +
         "\n";
}

}  // namespace

std::string sceneReportText(const Json& report) {
  return fitText(report) + section("models", report["models"], modelLine) +
         section("objects", report["objects"], objectLine) + section("probes", report["probes"], probeLine) +
         "sky\n  " + skyLine(report["sky"]) + "\n" + section("cameras", report["cameras"], cameraLine) +
         section("lights", report["lights"], lightLine) + section("lamps as shapes", report["lamps"], lampLine) +
         (report["lampRemarks"].empty() ? "" : section("remarks on lamps", report["lampRemarks"], word)) +
         section("skipped or not used", report["warnings"], word);
}

}  // namespace boxprobe
