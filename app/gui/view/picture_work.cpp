// See picture_work.h.
#include "app/gui/view/picture_work.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "app/gui/view/motion_preview.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/viewport.h"
#include "app/session/fit_scene.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

PictureWork::PictureWork(const Document& document, SceneRenderer& renderer, Viewport& viewport,
                         std::function<void()> beforePicture, QObject* parent)
    : QObject(parent),
      document_(document),
      renderer_(renderer),
      viewport_(viewport),
      beforePicture_(std::move(beforePicture)),
      scheduler_(new RenderScheduler({[this] {
                                        viewport_.noticeLostContext();
                                        return viewport_.readyToDraw();
                                      },
                                      [this] { draw(); }, [this] { return renderer_.workPending(); },
                                      [this] {
                                        guarded([this] {
                                          viewport_.window3d()->MakeCurrent();
                                          renderer_.step();
                                        });
                                      },
                                      [this] { return renderer_.workProgress(); },
                                      [this] { return renderer_.frameCount().more() && renderer_.error().empty(); }},
                                     this)),
      motion_(new MotionPreview({[this](bool allowed) { renderer_.allowStandIns(allowed); },
                                 [this](bool moving) { return renderer_.setMoving(moving); }},
                                this)),
      refinement_(new RestRefinement({[this] { return everRests(); },
                                      [this] {
                                        return viewport_.readyToDraw() && !document_.previewing() &&
                                               !motion_->active() && scheduler_->idle() && !renderer_.workPending();
                                      },
                                      [this](bool refined) {
                                        RefineSettings settings;
                                        if (refined) settings.rays = RefineSettings::kRays;
                                        guarded([&] {
                                          renderer_.refine(settings);
                                          // Given back in what moves, where smaller texels cost more and show nothing.
                                          renderer_.sharpenMirrors(refined ? viewport_.window3d()->GetSize()[1] : 0);
                                        });
                                      }},
                                     this)) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &PictureWork::rested);
  connect(scheduler_, &RenderScheduler::workEnded, this, &PictureWork::workEnded);
  connect(scheduler_, &RenderScheduler::rendered, this, &PictureWork::tellError);
  connect(motion_, &MotionPreview::enabledChanged, scheduler_, &RenderScheduler::sceneChanged);
  connect(motion_, &MotionPreview::cameToRest, scheduler_, &RenderScheduler::requestRender);
  connect(&viewport_, &Viewport::cameraMoved, refinement_, &RestRefinement::moved);
  connect(refinement_, &RestRefinement::switched, scheduler_, &RenderScheduler::requestRender);
  connect(&viewport_, &Viewport::cameraMoved, scheduler_, &RenderScheduler::requestRender);
  connect(&viewport_, &Viewport::cameraMoved, motion_, &MotionPreview::moved);
  connect(&viewport_, &Viewport::becameReady, scheduler_, &RenderScheduler::requestRender);
  connect(&viewport_, &Viewport::becameReady, this, [this] {
    if (viewport_.readyToDraw()) motion_->setDefault(viewport_.softwareRenderer());
  });
}

// Programs with the scene's numbers as constants are made once nothing has been edited for a while; each takes a turn
// of its own, as captures do.
void PictureWork::rested() {
  if (!viewport_.readyToDraw() || document_.previewing() || !scheduler_->idle() || renderer_.workPending()) {
    rest_.start();
    return;
  }
  guarded([this] { renderer_.specializePrograms(); });
  if (renderer_.workPending()) scheduler_->wake();
}

// A realtime probe is captured over and over, and its picture with it.
bool PictureWork::everRests() const {
  const auto& probes = document_.scene().probes;
  return !(plain_ && plain_()) && std::none_of(probes.begin(), probes.end(),
                                               [](const Probe& probe) { return probe.mode == ProbeMode::Realtime; });
}

template <typename Work>
void PictureWork::guarded(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    scheduler_->stopWork();  // it would fail again at every turn
    emit failed(QString::fromStdString(messageOf(error)));
  }
}

void PictureWork::draw() {
  guarded([this] {
    beforePicture_();
    viewport_.window3d()->Render();
  });
}

void PictureWork::workEnded() {
  if (firstPictureDone_ || renderer_.workPending()) return;
  firstPictureDone_ = true;
  emit firstPictureComplete();
}

void PictureWork::tellError() {
  if (renderer_.error() == toldError_) return;
  toldError_ = renderer_.error();
  if (!toldError_.empty()) emit failed(QString::fromStdString(toldError_));
}

void PictureWork::setRest(int milliseconds) {
  rest_.setInterval(milliseconds);  // begins anew if it runs
}

void PictureWork::syncScene(const Changes& changes) {
  rest_.start();
  refinement_->moved();
  if (document_.previewing()) {
    motion_->moved();
    renderer_.setInteractive(true);
  }
  renderer_.sync(document_.scene(), changes);
  if (!document_.previewing()) renderer_.setInteractive(false);
}

void PictureWork::editSettled() {
  refinement_->moved();
  motion_->rest();
  renderer_.setInteractive(document_.previewing());
  scheduler_->requestRender();
}

void PictureWork::setReflectionsShown(bool shown) {
  refinement_->moved();
  renderer_.setProbesEnabled(shown);
  scheduler_->requestRender();
}

void PictureWork::showCamera(int index) {
  const auto& cameras = document_.scene().cameras;
  if (static_cast<std::size_t>(index) < cameras.size()) place(cameras[static_cast<std::size_t>(index)]);
}

void PictureWork::resetCamera() {
  const auto& cameras = document_.scene().cameras;
  place(cameras.empty() ? fittedCamera(renderer_.bounds()) : cameras.front());
}

void PictureWork::place(const Camera& camera) {
  refinement_->moved();
  renderer_.applyCamera(camera);
  emit cameraPlaced();
  scheduler_->requestRender();
}

}  // namespace boxprobe
