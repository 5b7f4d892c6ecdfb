// See window_signals.h.
#include "app/gui/window/window_signals.h"

#include <QCoreApplication>
#include <QSocketNotifier>
#include <QTimer>
#include <exception>

#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/main_window.h"
#include "app/session/messages.h"
#include "filters/core/base/errors.h"

namespace boxprobe {

WindowSignals::WindowSignals(MainWindow& window) : window_(window) {
  if (!pipe_.isOpen()) throw WorkError("no pipe can be made; too many files are open");
  guard_ = std::make_unique<InterruptGuard>(pipe_.writeEnd());
  if (pipe_.readEnd() >= 0) {
    notifier_ = std::make_unique<QSocketNotifier>(pipe_.readEnd(), QSocketNotifier::Read);
    connect(notifier_.get(), &QSocketNotifier::activated, this, [this] { end(); });
  }
  timer_ = std::make_unique<QTimer>();
  connect(timer_.get(), &QTimer::timeout, this, [this] { keepUnsaved(); });
  timer_->start(500);
}

WindowSignals::~WindowSignals() {
  guard_.reset();
  keepForSignals({}, {});
}

int WindowSignals::exitStatus() const {
  return guard_->signalNumber() == 0 ? 0 : 128 + guard_->signalNumber();
}

void WindowSignals::keepUnsaved() {
  if (!notifier_ && guard_->interrupted()) return end();
  const Document& document = window_.document();
  if (document.modified() && document.scene() == kept_) return;
  const auto unsaved = window_.files().recovery();
  keepForSignals(unsaved ? unsaved->path : std::string(), unsaved ? unsaved->text : std::string());
  kept_ = unsaved ? document.scene() : Scene();
}

void WindowSignals::end() {
  if (notifier_) {
    notifier_->setEnabled(false);
  } else {
    timer_->stop();
  }
  (void)guard_->interrupted();  // seen
  try {
    const std::string path = window_.files().saveRecovery();
    if (!path.empty()) printNote("unsaved changes are in " + path);
    timer_->stop();
    keepForSignals({}, {});  // done: not once more if it takes long to close
  } catch (const std::exception& error) {
    window_.autosave().write();
    window_.autosave().keep();  // offered at the next start
    printError(std::string("unsaved changes are kept for the next start alone: ") + messageOf(error));
  }
  emit window_.closing();
  QCoreApplication::exit();  // of dialogs' own loops, too
}

}  // namespace boxprobe
