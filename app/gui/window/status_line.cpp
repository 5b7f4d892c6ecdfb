// See status_line.h.
#include "app/gui/window/status_line.h"

#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QStyle>
#include <QToolButton>

#include "app/gui/view/motion_preview.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/phrase_words.h"
#include "filters/core/scene/bounces.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kMessageMilliseconds = 8000;

}  // namespace

StatusLine::StatusLine(Workspace& workspace, QStatusBar* bar)
    : QObject(bar),
      bar_(bar),
      picture_(new QLabel(bar)),
      counters_(new QLabel(bar)),
      progress_(new QProgressBar(bar)),
      stop_(new QToolButton(bar)),
      resume_(new QToolButton(bar)) {
  progress_->setRange(0, 100);
  progress_->setFixedWidth(300);
  clock_.start();
  stop_->setText(tr("Stop"));
  stop_->setToolTip(tr("Stops the capture until the scene changes again (Esc)"));
  resume_->setText(tr("Continue capturing"));
  counters_->setToolTip(
      tr("Work since the start: cubemap faces captured, mip levels filtered, shader programs compiled, frames drawn; "
         "and how many draws of the last frame used no probe, one, two or more."));
  bar_->addPermanentWidget(progress_);
  bar_->addPermanentWidget(stop_);
  bar_->addPermanentWidget(resume_);
  picture_->setObjectName("pictureState");
  bar_->addPermanentWidget(picture_);
  bar_->addPermanentWidget(counters_);
  connect(&workspace, &Workspace::message, this, &StatusLine::showMessage);
  connect(&workspace, &Workspace::failed, this, &StatusLine::showError);
  connect(workspace.actions().counters, &QAction::toggled, this, &StatusLine::setCountersShown);
  RenderScheduler* scheduler = &workspace.scheduler();
  connect(stop_, &QToolButton::clicked, scheduler, &RenderScheduler::stopWork);
  connect(resume_, &QToolButton::clicked, scheduler, &RenderScheduler::resumeWork);
  connect(scheduler, &RenderScheduler::workProgressed, this,
          [this, &workspace](double fraction) { showProgress(fraction, workspace.renderer().workNow()); });
  connect(scheduler, &RenderScheduler::workEnded, this, [this, scheduler] { hideProgress(scheduler->workStopped()); });
  connect(scheduler, &RenderScheduler::rendered, this, [this, &workspace] {
    showCounters(workspace.renderer().counters());
    showPicture(workspace.renderer().frameCount(), workspace.picture().motion().active());
  });
  counters_->setObjectName("workCounters");
  hideProgress(false);
  showCounters({});
  setCountersShown(false);
  showPicture({}, false);
}

void StatusLine::showPicture(const FrameCount& frames, bool preview) {
  picture_->setVisible(preview || frames.wanted > 0);
  if (preview) {
    picture_->setText(tr("moving preview"));
    picture_->setToolTip(tr("A cheaper technique is shown while something moves (View menu)"));
  } else if (frames.refined) {
    picture_->setText(frames.more() ? tr("refining: %1 %").arg(100 * frames.averaged / frames.wanted) : tr("refined"));
    picture_->setToolTip(tr("The picture rests and goes on to what rays of the whole lobe show (View menu)"));
  } else if (frames.wanted > 0) {
    picture_->setText(tr("%1 of %2 frames averaged").arg(frames.averaged).arg(frames.wanted));
    picture_->setToolTip(tr("Mean since the last visible change"));
  }
}

void StatusLine::showCounters(const Counters& c) {
  std::uint64_t more = 0;
  for (std::size_t i = 2; i < c.drawsByProbeCount.size(); ++i) more += c.drawsByProbeCount[i];
  counters_->setText(tr("faces %1   levels %2   programs %3   renders %4   draws with 0/1/2+ probes: %5/%6/%7")
                         .arg(c.facesCaptured)
                         .arg(c.levelsFiltered)
                         .arg(c.programsCompiled)
                         .arg(c.renders)
                         .arg(c.drawsByProbeCount[0])
                         .arg(c.drawsByProbeCount[1])
                         .arg(more));
}

void StatusLine::setCountersShown(bool shown) {
  counters_->setVisible(shown);
}

QString StatusLine::workText(const WorkNow& now) {
  // The bar puts numbers in the place of what begins with this sign.
  const QString probe = QString::fromStdString(now.probe).remove('%');
  switch (now.what) {
    case WorkNow::What::Shadows:
      return tr("Shadows of lamps");
    case WorkNow::What::Coarse:
      return tr("%1, coarse").arg(probe);
    case WorkNow::What::Capture:
      if (probe.isEmpty()) return tr("Sky");
      if (now.bounces == kAllBounces) return tr("%1, bounce %2").arg(probe).arg(now.bounce);
      return now.bounces > 1 ? tr("%1, bounce %2 of %3").arg(probe).arg(now.bounce).arg(now.bounces) : probe;
    case WorkNow::What::Nothing:
    case WorkNow::What::Rest:
      break;
  }
  return tr("Capturing");
}

void StatusLine::showProgress(double fraction, const WorkNow& now) {
  const auto seconds = timeLeft_.update(fraction, 1e-3 * static_cast<double>(clock_.elapsed()));
  // What is left then is not counted: programs, each of which takes as long as the driver likes.
  const bool shaders = fraction >= 0.99;
  const QString text = shaders ? tr("Preparing shaders") : workText(now) + ": %p %";
  progress_->setToolTip(now.missing == 0 ? QString()
                                         : tr("%1 of %2 probes do not show their own surroundings yet: the sky or few "
                                              "texels stand in for them")
                                               .arg(now.missing)
                                               .arg(now.used));
  progress_->setFormat(seconds && !shaders ? text + ", " + phraseWords(TimeLeft::text(*seconds)) : text);
  progress_->setValue(static_cast<int>(100.0 * fraction));
  progress_->show();
  stop_->show();
  resume_->hide();
}

void StatusLine::hideProgress(bool stopped) {
  timeLeft_.restart();
  progress_->hide();
  stop_->hide();
  resume_->setVisible(stopped);
}

void StatusLine::showMessage(const QString& text) {
  setFailed(false);
  bar_->showMessage(text);
}

void StatusLine::showError(const QString& text) {
  setFailed(true);
  bar_->showMessage(text, kMessageMilliseconds);
}

// The colour stands in the application's style sheet.
void StatusLine::setFailed(bool failed) {
  if (bar_->property("failed").toBool() == failed) return;
  bar_->setProperty("failed", failed);
  bar_->style()->unpolish(bar_);
  bar_->style()->polish(bar_);
}

}  // namespace boxprobe
