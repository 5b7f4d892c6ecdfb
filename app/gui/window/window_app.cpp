// See window_app.h.
#include "app/gui/window/window_app.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QApplication>
#include <QDockWidget>
#include <QFontDatabase>
#include <QLocale>
#include <QProcess>
#include <QTimer>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>

#include "app/gui/lessons/lesson_view.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/settings_file.h"
#include "app/gui/widgets/window_language.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/recovery.h"
#include "app/gui/window/window_signals.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/stats_json.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/io/files/atomic_file.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

namespace {

/// Exceptions must not pass through Qt's event loop: what slips out of a handler is a message, and the window goes on.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  std::function<void(const std::string& line)> tell = printError;
  bool notify(QObject* receiver, QEvent* event) override {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      tell(messageOf(error));
      return false;
    }
  }
};

}  // namespace

void warnOfNoFonts() {
  // What Qt offers by itself stands for a font, and is there without any.
  const QStringList alone = {"Monospace", "Sans Serif", "Serif"};
#if QT_VERSION_MAJOR >= 6
  const QStringList families = QFontDatabase::families();
#else
  const QStringList families = QFontDatabase().families();
#endif
  const auto stands = [&](const QString& family) { return alone.contains(family); };
  if (std::all_of(families.begin(), families.end(), stands)) {
    printWarnings({"no fonts are installed, letters are drawn as boxes; install fonts-dejavu-core"});
  }
}

int runWindow(int& argc, char** argv, const std::string& scenePath, const WindowOptions& options) {
  LoadedScene loaded;
  FitWishes wishes;
  wishes.aspect = 1.25;  // of the picture beside the panels, in the window as it opens
  // First: bad input is told without a window flashing up.
  if (!scenePath.empty()) loaded = loadScene(scenePath, {}, {}, wishes);
  printWarnings(loaded.warnings);

  installVtkMessages(false, true);
  setSurfaceFormat();
  QCoreApplication::setApplicationName("Boxprobe");
  Application application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");    // Qt has taken the user's, and with it commas into every file's numbers
  QLocale::setDefault(QLocale::c());  // numbers are shown in one way, as files and documents have them
  warnOfNoFonts();
  loadLanguage(chosenLanguage());
  const int theme = chosenTheme().value_or(static_cast<int>(Theme::System));
  applyWindowStyle(application, static_cast<Theme>(theme));

  MainWindow window;
  const ScopeExit silent([&application] { application.tell = printError; });
  application.tell = [&window](const std::string& line) {
    printError(line);
    emit window.files().message(QString::fromStdString(line));
  };
  bool lost = false, startAgain = false;
  QObject::connect(&window.viewport(), &Viewport::contextLost, &window, [&] {
    lost = true;
    window.viewport().hide();  // Qt composes the whole window with the context while the picture is on show
    startAgain = offerRestart(window);
    if (startAgain) QCoreApplication::quit();
  });
  RunStats stats;
  std::optional<double> startToFirstFrame;
  std::string pictureError;
  QObject::connect(&window, &MainWindow::firstPictureComplete, [&] { startToFirstFrame = processCpuSeconds(); });
  QObject::connect(&window, &MainWindow::closing, [&] {
    window.viewport().window3d()->MakeCurrent();
    stats = collectStats(window.renderer(), window.viewport().window3d());
    pictureError = window.renderer().error();
  });
  if (!scenePath.empty()) {
    const std::string digest = loaded.fileDigest;
    window.showScene(loaded);
    window.viewport().setFocus();
    window.files().remember(QString::fromStdString(scenePath), digest);
  }
  window.lessons().setLanguage(options.language);
  if (const WindowLayout kept = windowLayout(); !kept.geometry.isEmpty()) {
    window.restoreGeometry(kept.geometry);
    window.restoreState(kept.docks);
    window.findChild<QDockWidget*>("lessons")->hide();  // none is open yet
  }
  window.show();
  if (windowLayout().geometry.isEmpty()) {
    constexpr int kOutliner = 230;  // names of a usual length, an eye and a lock
    window.resizeDocks({window.findChild<QDockWidget*>("outliner")}, {kOutliner}, Qt::Horizontal);
  }
  if (!options.lesson.empty()) window.openLesson(QString::fromStdString(options.lesson));
  const QStringList remarks = takeSettingsRemarks();
  for (const QString& line : remarks) printWarnings({line.toStdString()});
  const WindowSignals ended(window);
  QTimer::singleShot(0, &window, [&window, remarks] {
    for (const QString& line : remarks) emit window.files().message(line);
    offerRecovery(window);
  });
  QApplication::exec();

  stats.startToFirstFrameCpuSeconds = startToFirstFrame;
  if (!options.statsPath.empty()) writeTextAtomically(options.statsPath, statsJson(stats));
  if (lost) {  // Qt crashes where it destroys what a lost context had
    const Document& document = window.document();
    const std::vector<ModelFile>& models = document.scene().models;
    const std::string path = document.path().empty() && !models.empty() ? models.front().file : document.path();
    window.autosave().end();
    if (startAgain) {
      QProcess::startDetached(QCoreApplication::applicationFilePath(),
                              path.empty() ? QStringList() : QStringList(QString::fromStdString(path)));
    }
    std::fflush(nullptr);
    std::_Exit(startAgain ? 0 : ended.exitStatus());
  }
  if (!pictureError.empty()) throw WorkError(pictureError);
  return ended.exitStatus();
}

}  // namespace boxprobe
