// See lesson_models.h.
#include "app/gui/lessons/lesson_models.h"

#include <QFileInfo>
#include <QProgressDialog>
#include <algorithm>

#include "app/session/load_scene.h"

namespace boxprobe {

LessonModels::List LessonModels::load(const Scene& scene, const Scene& shownScene, const List& shown, QWidget* window) {
  for (std::size_t i = 0; i < shown.size() && i < shownScene.models.size(); ++i) {
    known_[shownScene.models[i].file] = shown[i];
  }
  Scene missing;
  for (const ModelFile& model : scene.models) {
    if (known_.count(model.file) == 0) missing.models.push_back(model);
  }
  if (!missing.models.empty()) {
    QProgressDialog progress(QProgressDialog::tr("Loading %1")
                                 .arg(QFileInfo(QString::fromStdString(missing.models.front().file)).fileName()),
                             QProgressDialog::tr("Cancel"), 0, 100, window);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(500);  // what is there at once needs none
    const List read = loadModels(missing, [&progress](double fraction) {
      progress.setValue(std::min(static_cast<int>(100.0 * fraction), 99));  // lets events through
      return !progress.wasCanceled();
    });
    for (std::size_t i = 0; i < read.size(); ++i) known_[missing.models[i].file] = read[i];
  }
  List models;
  for (const ModelFile& model : scene.models) models.push_back(known_.at(model.file));
  // Those of other scenes would pile up over an evening of lessons.
  known_.clear();
  for (std::size_t i = 0; i < models.size(); ++i) known_[scene.models[i].file] = models[i];
  return models;
}

}  // namespace boxprobe
