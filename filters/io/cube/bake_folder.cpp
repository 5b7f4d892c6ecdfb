#include "filters/io/cube/bake_folder.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

std::string joined(const std::vector<std::string>& views) {
  std::string text;
  for (const std::string& view : views) text += (text.empty() ? "" : ",") + view;
  return text.empty() ? "-" : text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> views;
  if (text == "-") return views;
  std::istringstream in(text);
  for (std::string view; std::getline(in, view, ',');) views.push_back(view);
  return views;
}

}  // namespace

std::string BakeRecord::text() const {
  return key + " " + view + " " + joined(sees) + " " + joined(known);
}

std::optional<BakeRecord> BakeRecord::parse(const std::string& text) {
  std::istringstream in(text);
  BakeRecord record;
  std::string sees, known, rest;
  if (!(in >> record.key >> record.view >> sees >> known) || in >> rest) return std::nullopt;
  record.sees = split(sees);
  record.known = split(known);
  return record;
}

BakeFolder::BakeFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  for (fs::directory_iterator it(path_, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".exr") continue;
    const std::string file = it->path().string();
    std::string damage;
    const auto mark = bakedProbeMark(file, &damage);
    const auto record = mark ? BakeRecord::parse(mark->inputHash) : std::nullopt;
    if (record) {
      // Of two files with the same maps, the one whose name others expect.
      const auto before = files_.find(record->key);
      if (before != files_.end() && !isEarlierBounce(before->second.path)) continue;
      files_[record->key] = {file, *record, {mark->program, mark->renderer}};
      keysOfView_.emplace(record->view, record->key);
    }
    if (!damage.empty()) damaged_.push_back(damage);
  }
}

bool BakeFolder::has(const std::string& key) const {
  const auto found = files_.find(key);
  if (found == files_.end()) return false;
  if (found->second.checked) return true;
  const std::string damage = bakedProbeDamage(found->second.path);
  if (damage.empty()) return found->second.checked = true;
  damaged_.push_back(damage);
  files_.erase(found);
  return false;
}

std::optional<BakeRecord> BakeFolder::record(const std::string& view) const {
  // An earlier bounce was made when fewer probes were known, or none.
  std::optional<BakeRecord> most;
  const auto range = keysOfView_.equal_range(view);
  for (auto it = range.first; it != range.second; ++it) {
    const auto file = files_.find(it->second);
    if (file == files_.end()) continue;
    const BakeRecord& record = file->second.record;
    if (!most || record.known.size() > most->known.size()) most = record;
  }
  return most;
}

BakedMaps BakeFolder::load(const std::string& key) const {
  return loadBakedProbe(files_.at(key).path).maps;
}

void BakeFolder::forget(const std::string& key, const std::string& damage) {
  files_.erase(key);
  if (!damage.empty()) damaged_.push_back(damage);
}

std::string BakeFolder::save(const std::string& folder, const Probe& probe, const BakeRecord& record, BakedMaps maps,
                             const BakeMaker& maker, int earlierBounce) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WorkError(folder + ": cannot create this folder: " + error.message());
  const std::string path = (fs::path(folder) / fileName(probe.name, earlierBounce)).string();
  BakedProbeFile file;
  file.maps = std::move(maps);
  file.info.probe = probe;
  if (probe.name.empty()) file.info.probe.name = "sky";  // a probe without a name could not be read back
  file.info.inputHash = record.text();
  file.info.program = maker.program;
  file.info.renderer = maker.renderer;
  saveBakedProbe(path, file);
  return path;
}

namespace {

// Not part of any probe's name, where it would be escaped.
constexpr char kBounceMark = '~';

}  // namespace

bool BakeFolder::isEarlierBounce(const std::string& fileName) {
  const std::string stem = fs::path(fileName).stem().string();
  const std::size_t mark = stem.rfind(kBounceMark);
  return mark != std::string::npos && mark + 1 < stem.size() &&
         stem.find_first_not_of("0123456789", mark + 1) == std::string::npos;
}

std::string BakeFolder::fileName(const std::string& probeName, int earlierBounce) {
  if (probeName.empty()) return "_sky.exr";
  std::string name;
  for (const char c : probeName) {
    const bool letter = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    // Not as the first character: `_sky` is the sky's, and a leading dot hides a file.
    const bool inner = !name.empty() && (c == '_' || c == '.' || c == ' ');
    if (letter || inner) {
      name += c;
    } else {
      char escaped[4];
      std::snprintf(escaped, sizeof escaped, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
      name += escaped;
    }
  }
  if (earlierBounce > 0) name += kBounceMark + std::to_string(earlierBounce);
  return name + ".exr";
}

std::string BakeFolder::besideScene(const std::string& scenePath) {
  std::string stem = scenePath;
  for (const char* ending : {".json", ".boxprobe", ".glb", ".gltf"}) {
    const std::string end(ending);
    if (stem.size() > end.size() && stem.compare(stem.size() - end.size(), end.size(), end) == 0) {
      stem.resize(stem.size() - end.size());
    }
  }
  return stem + ".probes";
}

}  // namespace boxprobe
