// See ground_work.h.
#include "filters/vtk/scene/ground_work.h"

#include <utility>

namespace boxprobe {

GroundWork::~GroundWork() {
  end();
}

void GroundWork::end() {
  if (!run_) return;
  run_->stop = true;
  if (run_->result.valid()) run_->result.wait();
  run_.reset();
}

void GroundWork::forget() {
  end();
  key_.clear();
  known_.reset();
}

void GroundWork::ask(const std::string& key, const Scene& scene,
                     const std::vector<std::shared_ptr<const Model>>& models, const SightLinesMaker& lines,
                     const Box& bounds) {
  if (key == key_) return;
  end();
  key_ = key;
  run_ = std::make_unique<Run>();
  run_->result = std::async(std::launch::async, [scene, models, lines, bounds, stop = &run_->stop] {
    const std::shared_ptr<const SightLines> through = lines(scene, models);
    return through ? tracedGroundShadow(*through, bounds, [stop] { return stop->load(); }) : GroundShadow{};
  });
}

std::shared_ptr<const GroundShadow> GroundWork::shadow(std::chrono::milliseconds wait) {
  if (run_ && run_->result.wait_for(wait) == std::future_status::ready) {
    const std::unique_ptr<Run> ended = std::move(run_);
    known_ = std::make_shared<const GroundShadow>(ended->result.get());
  }
  return known_;
}

}  // namespace boxprobe
