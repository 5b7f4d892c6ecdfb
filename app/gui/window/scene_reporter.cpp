// See scene_reporter.h.
#include "app/gui/window/scene_reporter.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <exception>
#include <optional>
#include <utility>

#include "app/gui/edit/work_beside.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/session/offscreen_scene.h"
#include "app/session/opened_glb.h"
#include "app/session/output_check.h"
#include "app/web/review_page.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

SceneReporter::SceneReporter(Workspace& workspace, QWidget* window)
    : QObject(window), workspace_(workspace), window_(window) {
  workspace.listenTo(this);
  connect(workspace.actions().report, &QAction::triggered, this, &SceneReporter::ask);
}

void SceneReporter::ask() {
  QString path = QFileDialog::getSaveFileName(
      window_, tr("Report"), QDir(workspace_.folderShown()).filePath("report.html"), tr("Pages (*.html)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) {
    path += ".html";
    if (!mayOverwrite(window_, tr("Report"), path)) return;
  }
  write(path);
}

bool SceneReporter::write(const QString& path) {
  if (workBesideRuns()) {
    emit message(tr("Wait until what is being read or fitted is done"));
    return false;
  }
  try {
    requireExtension("Report", path.toStdString(), {".html", ".htm"});
    requireWritable("Report", path.toStdString());
    LoadedScene shown;
    shown.scene = workspace_.document().scene();
    shown.models = workspace_.models();
    shown.path = workspace_.document().path();
    ReviewSettings settings = settings_;
    settings.cameras = shown.scene.cameras;
    if (settings.cameras.empty()) settings.cameras = {workspace_.renderer().currentCamera()};
    const std::string scene = ownPathOf(shown.path, shown.scene);
    const std::string command = "boxprobe report " + scene + " -o " + path.toStdString();
    std::optional<SceneReview> review;
    workBeside(window_, tr("Drawing and path tracing the cameras for the report"), true,
               [&](const BesideProgress& progress) {
                 OffscreenSettings hidden;
                 hidden.command = "boxprobe";
                 hidden.beside = true;
                 OffscreenScene drawn(hidden);
                 review = reviewScene(std::move(shown), drawn, settings, progress);
               });
    if (!review) {
      emit message(tr("The report was cancelled; nothing was written"));
      return false;
    }
    ReviewPage page({command, std::nullopt, settings});
    page.add(*review);
    writeTextAtomically(path.toStdString(), page.text());
    emit message(tr("Wrote %1; the largest error of a camera is %2").arg(path).arg(review->worstError(), 0, 'f', 3));
    return true;
  } catch (const std::exception& error) {
    emit failed(tr("No report: %1").arg(QString::fromStdString(messageOf(error))));
    return false;
  }
}

}  // namespace boxprobe
