#include "filters/io/engines/probe_export.h"

#include <algorithm>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/engines/cube_container.h"
#include "filters/io/engines/engine_files.h"
#include "filters/io/engines/export_cube.h"
#include "filters/io/engines/export_names.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/image/image_file.h"

namespace boxprobe {

namespace {

constexpr int kDiffuseSize = 32;  // more resolution than nine coefficients need

bool isCube(const std::string& format) {
  return format == "ktx2" || format == "dds";
}

/// One line about what is lost, or an empty one.
std::string lossText(const ProbeCapture& capture, const std::string& format) {
  const HalfLoss loss = halfLoss(capture.level0);
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (loss.texelsNotFinite > 0) add(std::to_string(loss.texelsNotFinite) + " texels are no numbers");
  if (loss.texelsAtLimit > 0 || capture.clamped) {
    add(loss.texelsAtLimit > 0
            ? std::to_string(loss.texelsAtLimit) + " texels are 65504, the largest half float, or more"
            : "its source is brighter than 65504, the largest half float");
  }
  if (format == "hdr" && coversPartly(capture.level0)) add("its coverage (alpha) has no place in a Radiance picture");
  return text;
}

void writeCube(const std::string& path, const CubeMap& cube, const ExportSettings& settings) {
  writeTextAtomically(path, settings.format == "ktx2" ? encodeKtx2(cube, settings.writer) : encodeDds(cube));
}

}  // namespace

const std::vector<std::string>& exportFormats() {
  static const std::vector<std::string> formats = {"ktx2", "dds", "exr", "hdr"};
  return formats;
}

void checkExportSettings(const ExportSettings& settings) {
  const auto& formats = exportFormats();
  if (std::find(formats.begin(), formats.end(), settings.format) == formats.end()) {
    throw InputError("--format " + settings.format + ": no such format; there are: " + nameList(formats) + " and web");
  }
  if (findLadder(settings.ladder) == nullptr) {
    throw InputError("--ladder " + settings.ladder + ": no such ladder; there are: " + ladderIdList());
  }
  const int size = settings.faceSize;
  if (size != 0 && (size < kLeastExportSize || size > kMostExportSize || (size & (size - 1)) != 0)) {
    throw InputError("--size " + std::to_string(size) + ": expected a power of two from " +
                     std::to_string(kLeastExportSize) + " to " + std::to_string(kMostExportSize) +
                     ", texels along a face");
  }
}

CubeMap exportedLevel0(const ProbeCapture& capture, const ExportSettings& settings, Probe& probe) {
  CubeMap level0 = resizedCube(capture.level0, settings.faceSize == 0 ? capture.level0.faceSize() : settings.faceSize);
  if (capture.capturedRotation != probe.rotationDegrees) {
    level0 = rotatedCube(level0, glm::mat3(glm::transpose(rotationMatrix(capture.capturedRotation)) *
                                           rotationMatrix(probe.rotationDegrees)));
  }
  if (!settings.center || probe.origin == probe.box.center()) return level0;
  const ProbeGeometry g = probeGeometry(probe, probe.origin, probe.rotationDegrees);
  probe.origin = probe.box.center();
  return recentredCube(level0, g.boxMin, g.boxMax, 0.5f * g.boxMin + 0.5f * g.boxMax);
}

std::vector<std::string> exportProbes(const std::vector<ProbeCapture>& captures, const ExportSettings& settings,
                                      const std::string& folder, const std::function<bool(double)>& progress) {
  checkExportSettings(settings);
  const LadderRow& ladder = *findLadder(settings.ladder);
  std::vector<std::string> names, files;
  for (const ProbeCapture& capture : captures) {
    names.push_back(capture.probe.name);
    const std::string lost = settings.lossy ? "" : lossText(capture, settings.format);
    if (!lost.empty()) {
      throw InputError("probes." + capture.probe.name + ": " + lost + "; --lossy writes the nearest that --format " +
                       settings.format + " holds");
    }
  }
  const std::vector<std::string> stems = exportStems(names);
  const auto pathOf = [&folder](const std::string& name) { return (std::filesystem::path(folder) / name).string(); };
  const auto write = [&](const std::string& name, const std::string& text) {
    files.push_back(pathOf(name));
    writeTextAtomically(files.back(), text);
  };
  std::vector<ExportedProbe> written;
  for (std::size_t i = 0; i < captures.size(); ++i) {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(captures.size()))) return files;
    ExportedProbe exported;
    exported.probe = captures[i].probe;
    exported.capturedAt = exported.probe.origin;
    exported.file = stems[i] + "." + settings.format;
    exported.format = settings.format;
    exported.writer = settings.writer;
    exported.ladder = &ladder;
    const CubeMap level0 = exportedLevel0(captures[i], settings, exported.probe);
    exported.faceSize = level0.faceSize();
    files.push_back(pathOf(exported.file));
    if (isCube(settings.format)) {
      const CubeMap chain = ladderChain(level0, ladder, exported.probe.filterSamples);
      exported.levels = chain.levels();
      writeCube(files.back(), turnedCube(chain, ladder.lookup), settings);
      if (ladder.diffuse) {
        exported.diffuseFile = stems[i] + "_diffuse." + settings.format;
        files.push_back(pathOf(exported.diffuseFile));
        const glm::mat3 turn(rotationMatrix(exported.probe.rotationDegrees));
        writeCube(files.back(), turnedCube(diffuseCube(captures[i].irradiance, turn, kDiffuseSize), ladder.lookup),
                  settings);
      }
    } else {
      const ImageRgbaF picture = latLongPicture(level0, ladder.latLongCentre);
      settings.format == "exr" ? saveExr(files.back(), picture) : saveRadiance(files.back(), picture);
    }
    write(stems[i] + ".json", probeJson(exported));
    written.push_back(exported);
  }
  for (const EngineFile& file : engineFiles(written, settings.format, settings.ladder)) write(file.name, file.text);
  return files;
}

}  // namespace boxprobe
