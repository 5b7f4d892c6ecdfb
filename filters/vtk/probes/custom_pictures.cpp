#include "filters/vtk/probes/custom_pictures.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/vtk/probes/capture_key.h"

namespace boxprobe {

void CustomPictures::update(const Scene& scene) {
  error_.clear();
  std::vector<const Picture*> readNow;  // other probes may name the same
  for (const Probe& probe : scene.probes) {
    if (probe.mode != ProbeMode::Custom) continue;
    const std::string place = "probes." + probe.name + ".image: ";
    const auto it = pictures_.find(probe.name);
    if (it == pictures_.end() || !it->second.isOf(probe)) {
      Picture& picture = pictures_[probe.name];
      picture.file = probe.image;
      picture.layout = probe.imageLayout;
      picture.code = {probe.encoding, probe.decode};
      picture.view = probe.cubeView;
      picture.rotationDegrees = probe.imageRotationDegrees;
      picture.error.clear();
      try {
        if (probe.image.empty()) throw InputError("mode custom needs the path of a picture");
        const auto same = std::find_if(readNow.begin(), readNow.end(), [&](auto* read) { return read->isOf(probe); });
        if (same != readNow.end()) {
          picture.repairs = (*same)->repairs;
          picture.cube = (*same)->cube;
        } else {
          LoadedCube loaded = loadCustomCube(probe);
          picture.repairs = std::move(loaded.repairs);
          picture.cube = std::make_shared<const CubeMap>(std::move(loaded.radiance));
          readNow.push_back(&picture);
        }
        picture.key.clear();
      } catch (const InputError& error) {
        picture.error = place + error.what();
      }
    }
    if (error_.empty()) error_ = pictures_[probe.name].error;
  }
}

std::shared_ptr<const CubeMap> CustomPictures::picture(const std::string& probeName) const {
  const auto it = pictures_.find(probeName);
  return it != pictures_.end() ? it->second.cube : nullptr;
}

std::vector<std::string> CustomPictures::remarks() const {
  std::vector<std::string> texts;
  for (const auto& [name, picture] : pictures_) {
    const std::string place = "probes." + name + ".image: " + picture.file + ": ";
    for (const std::string& sentence : picture.repairs.sentences()) texts.push_back(place + sentence);
  }
  return texts;
}

std::string CustomPictures::key(const Probe& probe) const {
  const auto it = pictures_.find(probe.name);
  if (it == pictures_.end() || !it->second.cube) return {};
  Picture& picture = it->second;
  if (picture.key.empty() || picture.keyFilter != probe.filter || picture.keySamples != probe.filterSamples) {
    picture.key = importKey(probe, *picture.cube);
    picture.keyFilter = probe.filter;
    picture.keySamples = probe.filterSamples;
  }
  return picture.key;
}

}  // namespace boxprobe
