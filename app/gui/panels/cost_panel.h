// What each technique costs and how wrong it is in the open scene: the chart that `boxprobe bench` draws, with the
// selected probe's technique ringed, and the numbers behind it; a technique is chosen by double-clicking its row. The
// measuring itself is a process of its own, so the window stays live and the times are not its times.
#pragma once

#include <QProcess>
#include <QTemporaryDir>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/core/picture/pareto_front.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;
class QTreeWidget;

namespace boxprobe {

class Workspace;

class CostPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CostPanel(Workspace& workspace);
  ~CostPanel() override;

  /// What measures: this program itself, unless a test says otherwise.
  void setProgram(const QString& path) { program_ = path; }
  /// Draws only while it can be seen.
  void setWatched(bool watched);
  bool measuring() const;
  /// The scene file that was measured last.
  QString measuredScene() const { return process_.arguments().value(1); }

  /// Where the results of a scene lie: `room.bench` beside `room.boxprobe.json`.
  static std::string folderBeside(const std::string& scenePath);

 signals:
  void message(const QString& text);
  void failed(const QString& line);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// The document changed. Another scene was opened: what an earlier benchmark left beside it is shown, else the table
  /// of the example scene that comes with the program, marked as such. Saved under another name it is the same scene,
  /// and what was measured stays.
  void update();
  void useScene(const std::string& scenePath);
  QString sceneToMeasure();
  void enableButtons();
  void measure(bool quick);
  void readProgress();
  void measured(int exitCode, QProcess::ExitStatus status);
  void load();
  void showCurrent(bool always);
  void fillTable();
  void drawChart();
  std::string currentLabel() const;

  Editor& editor_;
  bool another_ = false;                   ///< another scene is on its way
  std::string folder_;                     ///< of the results
  std::unique_ptr<QTemporaryDir> own_;     ///< of a scene that is not saved as it is shown
  std::unique_ptr<QTemporaryDir> ending_;  ///< of the process that was asked to end
  bool shipped_ = false;                   ///< the points are of the example scene
  std::vector<ParetoPoint> points_;
  std::string shownLabel_;
  bool watched_ = false, onDark_ = false;
  QByteArray output_;
  QString program_;
  QProcess process_;
  QLabel* chart_;
  QLabel* state_;
  QTreeWidget* table_;
  QProgressBar* progress_;
  QPushButton* quick_;
  QPushButton* full_;
  QPushButton* stop_;
  QTimer* redraw_;
};

}  // namespace boxprobe
