// See reference_picture.h.
#include "app/cli/command/reference_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/cli/farm/picture_shares.h"
#include "app/session/display_picture.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/opened_glb.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/reference_box_picture.h"
#include "app/session/scene_work.h"
#include "app/session/shared_work.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/scene/bounces.h"
#include "filters/core/scene/material_override.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/platform/process.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/path/reference_path.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

constexpr const char* kBox = "reference-box";
constexpr const char* kScene = "reference-scene";
constexpr const char* kPath = "reference-path";

/// Nothing: all. Throws InputError.
std::optional<int> bouncesOf(const RenderOptions& options, const Scene& scene) {
  if (options.bounces == "all") return std::nullopt;
  if (options.bounces.empty()) {
    if (scene.probes.empty()) return std::nullopt;
    return mostBounces(scene);
  }
  constexpr int kMost = 1000;
  int bounces = 0;
  char rest = 0;
  if (std::sscanf(options.bounces.c_str(), "%d%c", &bounces, &rest) != 1 || bounces < 0 || bounces > kMost) {
    throw InputError("--bounces " + options.bounces + ": expected a whole number from 0 to 1000, or all");
  }
  return bounces;
}

std::string bouncesText(const std::optional<int>& bounces) {
  return bounces ? std::to_string(*bounces) : "all";
}

ReferencePicture tracePaths(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options,
                            PathQuantity quantity, const PicturePart& part, const ReferenceProgress& progress) {
  const FrameSize size = parseFrameSize(options.size);
  PathSettings settings;
  settings.quantity = quantity;
  settings.width = size.width;
  settings.height = size.height;
  settings.raysPerPixel = options.rays;
  settings.bounces = bouncesOf(options, loaded.scene);
  settings.part = part;
  const ReferencePath path(loaded.scene, loaded.models, loadSkyImage(loaded.scene));
  if (!options.report.quiet) printWarnings(path.remarks());
  return path.render(camera, settings, progress);
}

/// Does something scatter light that probes bring it, as shapes and lattices? Not all of it is known without a capture.
bool probesLightSurfaces(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  if (scene.probes.empty() || scene.lamps != LampForm::Shapes) return false;
  for (const auto& model : loaded.models) {
    for (const Material& material : model->materials) {
      const Material drawn = overriddenMaterial(material, scene);
      const bool allMetal = drawn.metallic == 1.0f && !drawn.metallicRoughnessTexture.image;
      if (!drawn.unlit && (!allMetal || drawn.finish.hasSheen())) return true;
    }
  }
  return false;
}

/// The light that the probes throw on what the camera sees, as its picture has it; null: no surface scatters any.
std::shared_ptr<const ProbesDiffuse> lightOfProbes(const LoadedScene& loaded, const Camera& camera,
                                                   const RenderOptions& options, const InterruptGuard& interrupt) {
  if (!probesLightSurfaces(loaded)) return nullptr;
  const FrameSize size = parseFrameSize(options.size);
  OffscreenScene shown({"boxprobe render", size.width, size.height, 1, options.report.quiet, false,
                        options.report.offscreen, drawsLittle(1, loaded.scene.probes.size())});
  ShownSettings settings{camera};
  settings.bakedFolder = bakedFolderOf(options.scenePath);
  shown.show(loaded.scene, loaded.models, settings);
  captureShown(shown, interrupt, options.report.quiet);
  shown.renderer().renderLinear(size.width, size.height, 1);  // lattices are derived when a frame asks for them
  auto light = std::make_shared<const ProbesDiffuse>(shown.renderer().probesDiffuse());
  shown.requireHealthy();
  return light;
}

ReferencePicture traceScene(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options,
                            const PicturePart& part, std::shared_ptr<const ProbesDiffuse> diffuse,
                            const ReferenceProgress& progress) {
  const FrameSize size = parseFrameSize(options.size);
  ReferenceSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.samplesPerPixel = options.samples;
  settings.raysPerPixel = options.rays;
  settings.full = options.full;
  settings.part = part;
  settings.diffuse = std::move(diffuse);
  const SceneOfDrawnSky drawn = withDrawnSky(loaded.scene);
  return ReferenceScene(drawn.scene, loaded.models, drawn.skyImage).render(camera, settings, progress);
}

/// The chain a probe of this filter holds is blurred already.
ReferenceBoxMaps readMaps(SceneRenderer& renderer, const Scene& scene, bool quiet) {
  for (const Probe& probe : scene.probes) {
    if (probe.filter == FilterKind::Gaussian && !quiet) {
      printWarnings({"probes." + probe.name +
                     ".filter: gaussian blurs the capture, and reference-box integrates over the blurred capture; set "
                     "it to ggx to judge the lobe alone"});
    }
  }
  return boxMaps(renderer, scene);
}

ReferencePicture boxPicture(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options,
                            const InterruptGuard& interrupt, const ReferenceProgress& progress) {
  const FrameSize size = parseFrameSize(options.size);
  OffscreenScene shown({"boxprobe render", size.width, size.height, 1, options.report.quiet, false,
                        options.report.offscreen, drawsLittle(1, loaded.scene.probes.size())});
  ShownSettings settings{camera};
  settings.bakedFolder = bakedFolderOf(options.scenePath);
  shown.show(loaded.scene, loaded.models, settings);
  captureShown(shown, interrupt, options.report.quiet);
  ReferencePicture picture =
      integrateBox(shown.renderer(), readMaps(shown.renderer(), loaded.scene, options.report.quiet),
                   {size.width, size.height, options.samples, options.rays, {}}, progress);
  shown.requireHealthy();
  return picture;
}

void savePicture(const std::string& path, const ReferencePicture& picture, bool linear, const Scene& scene) {
  if (linear) {
    std::vector<ExtraChannel> errors;
    for (const std::size_t c : {0u, 1u, 2u}) {
      ExtraChannel channel{std::string("standardError.") + "RGB" [c], {}};
      for (std::size_t i = c; i < picture.standardError.pixels.size(); i += 4) {
        channel.values.push_back(picture.standardError.pixels[i]);
      }
      errors.push_back(std::move(channel));
    }
    saveExr(path, picture.color, errors);
    return;
  }
  savePng(path, displayPicture(picture.color, scene.exposure, scene.tone));
}

struct ErrorSummary {
  double rootMeanSquare = 0.0, largest = 0.0;
};

ErrorSummary summary(const ReferencePicture& picture) {
  ErrorSummary result;
  const std::vector<float>& errors = picture.standardError.pixels;
  for (const float e : errors) {
    result.rootMeanSquare += static_cast<double>(e) * e;
    result.largest = std::max(result.largest, static_cast<double>(e));
  }
  result.rootMeanSquare = std::sqrt(result.rootMeanSquare / std::max(0.75 * static_cast<double>(errors.size()), 1.0));
  return result;
}

std::string referenceJson(const RenderOptions& options, const Scene& scene, const ErrorSummary& error,
                          double cpuSeconds) {
  nlohmann::ordered_json json = {{"reference",
                                  {{"technique", options.technique},
                                   {"raysPerPixel", options.rays},
                                   {"samplesPerPixel", options.samples},
                                   {"full", options.full},
                                   {"standardErrorRms", error.rootMeanSquare},
                                   {"standardErrorMax", error.largest}}},
                                 {"times", {{"referenceCpuSeconds", cpuSeconds}}}};
  if (options.rays == 1) json["reference"]["standardErrorRms"] = json["reference"]["standardErrorMax"] = nullptr;
  if (options.technique == kPath) {
    const FrameSize size = parseFrameSize(options.size);
    const double paths = 1.0e-6 * size.width * size.height * options.rays;
    json["reference"].erase("full");
    json["reference"].erase("samplesPerPixel");
    json["reference"]["bounces"] = bouncesText(bouncesOf(options, scene));
    json["times"]["cpuSecondsPerMegapixelAndRay"] = cpuSeconds / paths;
    json["memoryBytes"]["peakResident"] = peakResidentBytes();
  }
  return validJson(json);
}

/// What a traced picture depends on: bands with the same key are of the same picture.
std::string pictureKey(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options) {
  ContentHash hash;
  hash.add(loadedSceneKey(loaded)).add(camera.name).add(options.size);
  hash.add(options.samples).add(options.rays).add(options.full ? 1.0 : 0.0);
  if (options.technique == kPath) hash.add(kPath).add(bouncesText(bouncesOf(options, loaded.scene)));
  return hash.text().substr(0, 16);
}

/// The share this process has of the picture, if it is not alone.
std::optional<BakeShare> pictureShare(const RenderOptions& options) {
  if (!options.shard.empty()) return parseBakeShare(options.shard);
  return options.technique == kBox ? std::nullopt : mpiShare();
}

/// Traces this share's rows unless they are there; the whole picture once all are, else nothing.
std::optional<ReferencePicture> sharedPicture(const BakeShare& share, const std::string& key,
                                              const RenderOptions& options,
                                              const std::function<ReferencePicture(const PicturePart&)>& trace) {
  const FrameSize size = parseFrameSize(options.size);
  const PicturePart part = rowsOfShare(size.width, size.height, share);
  // A band has its rows twice.
  if (2 * static_cast<std::int64_t>(size.width) * (part.bottom - part.top) > limits::kPicturePixels) {
    throw InputError("--shard " + options.shard + ": too many pixels in a share of --size " + options.size +
                     "; use more shares");
  }
  const std::string band = bandPath(options.outputPath, share, key);
  const bool none = part.top >= part.bottom;
  requireShortName("-o", band);
  if (!none && !std::filesystem::exists(band)) {
    const ReferencePicture rows = trace(part);
    if (!rows.complete) throw WorkError("interrupted; the rows of this share are not kept");
    saveBand(band, rows, part);
  }
  JoinedBands joined = joinBands(options.outputPath, size.width, size.height, share.count, key);
  if (joined.missing == 0 && !joined.elsewhere) return std::move(joined.picture);
  // A band that is gone was taken by whoever has put the picture together.
  const bool written = joined.elsewhere || (!none && !std::filesystem::exists(band));
  if (!written && !options.report.quiet) {
    printResult(band + ": rows " + std::to_string(part.top) + " to " + std::to_string(part.bottom) + "; " +
                std::to_string(joined.missing) + " of " + std::to_string(share.count) + " shares are missing\n");
  }
  return std::nullopt;
}

void refuse(const std::string& option, const RenderOptions& options) {
  throw InputError(option + " is not for --technique " + options.technique + ": leave one of them out");
}

}  // namespace

bool isReference(const std::string& technique) {
  return technique == kBox || technique == kScene || technique == kPath;
}

bool comparesDiffuse(const std::string& view) {
  return view == "diffuse-error" || view == kAllViews;
}

ImageRgbaF traceDiffuse(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options,
                        const InterruptGuard& interrupt) {
  RenderOptions traced = options;
  constexpr int kSheetRays = 16;  // a sheet is an overview: its other views take seconds
  if (options.view == kAllViews && options.rays == kDefaultReferenceRays) traced.rays = kSheetRays;
  ProgressLine line("diffuse light", !options.report.quiet);
  const ReferencePicture light = tracePaths(loaded, camera, traced, PathQuantity::DiffuseLight, {}, [&](double done) {
    line.show(done);
    return !interrupt.interrupted();
  });
  interrupt.check();
  return diffuseTruthImage(light);
}

void refuseReferenceOptions(const RenderOptions& options) {
  const std::string advice =
      " is for --technique reference-scene, reference-path or reference-box, and for --view diffuse-error or all";
  if (options.full) throw InputError("--full is for --technique reference-scene alone");
  if (!options.shard.empty()) throw InputError("--shard is for --technique reference-scene or reference-path alone");
  if (comparesDiffuse(options.view)) return;
  if (!options.bounces.empty()) {
    throw InputError("--bounces is for --technique reference-path, and for --view diffuse-error or all");
  }
  if (options.rays != kDefaultReferenceRays) throw InputError("--rays " + std::to_string(options.rays) + advice);
}

void renderReference(const RenderOptions& options, bool linear) {
  if (!options.view.empty()) refuse("--view " + options.view, options);
  if (!options.refine.empty()) refuse("--refine", options);
  if (options.frames > 0) refuse("--frames " + std::to_string(options.frames), options);
  if (options.probes != "on") refuse("--probes " + options.probes, options);
  const bool box = options.technique == kBox, path = options.technique == kPath;
  if (options.technique != kScene && options.full) refuse("--full", options);
  if (!path && !options.bounces.empty()) refuse("--bounces " + options.bounces, options);
  if (box && !options.shard.empty()) refuse("--shard", options);
  const std::optional<BakeShare> share = pictureShare(options);

  InterruptGuard interrupt;
  const LoadedScene loaded = loadScene(options.scenePath, options.assignments);
  const Camera camera = chooseCamera(loaded.scene, options.camera);
  if (path) (void)bouncesOf(options, loaded.scene);  // refused before anything is traced
  if (!options.report.quiet) printWarnings(loaded.warnings);
  interrupt.check();

  const double start = processCpuSeconds();
  const auto make = [&](const PicturePart& part) {
    const auto diffuse = options.technique == kScene ? lightOfProbes(loaded, camera, options, interrupt) : nullptr;
    ProgressLine line(options.technique, !options.report.quiet);  // wiped before anything else is printed
    const auto progress = [&](double done) {
      line.show(done);
      interrupt.waitForPartialResults();
      return !interrupt.interrupted();
    };
    if (path) return tracePaths(loaded, camera, options, PathQuantity::Radiance, part, progress);
    return box ? boxPicture(loaded, camera, options, interrupt, progress)
               : traceScene(loaded, camera, options, part, diffuse, progress);
  };
  const std::string key = share ? pictureKey(loaded, camera, options) : std::string();
  const auto whole = share ? sharedPicture(*share, key, options, make) : std::optional<ReferencePicture>(make({}));
  if (!whole) return;  // others have the rest
  const ReferencePicture& picture = *whole;
  if (!picture.complete) {
    const std::string partial = options.outputPath + ".partial";
    savePicture(partial, picture, linear, loaded.scene);
    throw WorkError("interrupted; the partial picture is in " + partial);
  }
  savePicture(options.outputPath, picture, linear, loaded.scene);
  if (share) removeBands(options.outputPath, share->count, key);
  const ErrorSummary error = summary(picture);
  const std::string json = referenceJson(options, loaded.scene, error, processCpuSeconds() - start);
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, json);
  if (options.report.json) {
    printDocument(json);
  } else if (!options.report.quiet) {
    char errors[96] = "unknown from one ray";
    if (options.rays > 1) {
      std::snprintf(errors, sizeof errors, "%.2g (root mean square), %.2g at most", error.rootMeanSquare,
                    error.largest);
    }
    printResult(options.outputPath + ": " + std::to_string(picture.color.width) + " x " +
                std::to_string(picture.color.height) + ", camera " + camera.name + ", " + options.technique + ", " +
                std::to_string(options.rays) + " rays per pixel, standard error " + errors + "\n");
  }
}

}  // namespace boxprobe
