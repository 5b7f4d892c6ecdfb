#include "filters/vtk/maps/level_reader.h"

#include <algorithm>

#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

int levelCount(const ProbeMaps& maps) {
  return maps.radiance.levels();
}

int faceSize(const ProbeMaps& maps) {
  return maps.radiance.faceSize();
}

void LevelReader::start(std::shared_ptr<const ProbeMaps> maps, int level, bool distance) {
  stop();
  cube_ = {};
  if (!maps) return;
  maps_ = std::move(maps);
  texture_ = distance ? &maps_->distance : &maps_->radiance;
  if (!texture_->allocated()) return stop();
  level_ = std::clamp(level, 0, texture_->levels() - 1);
  cube_ = CubeMap(std::max(texture_->faceSize() >> level_, 1), 1);
  face_ = 0;
}

void LevelReader::stop() {
  face_ = 6;
  texture_ = nullptr;
  maps_.reset();
}

void LevelReader::step() {
  if (!pending()) return;
  if (texture_ == &maps_->radiance) maps_->need(LevelMask{1} << level_);
  const std::vector<float> rgba = texture_->readFace(face_, level_);
  std::copy(rgba.begin(), rgba.end(), cube_.face(0, face_));
  if (++face_ == 6) stop();
}

}  // namespace boxprobe
