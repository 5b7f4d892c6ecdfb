// Fits the selected probe's box to what it sees, in a thread of its own, and lets its user review the result before it
// counts: both errors, the gain of each face, the fitted box drawn beside the old one. Called by the docks; the
// mathematics is filters/fit's.
#pragma once

#include <QWidget>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"
#include "filters/fit/box/fit_box.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QWidget;

namespace boxprobe {

class FitPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FitPanel(Editor& editor, QWidget* parent = nullptr);
  /// Stops the fit under way and waits for it.
  ~FitPanel() override;

  /// In the order of scene.models.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models) { models_ = models; }
  /// The document changed: a result for what is no longer so is dropped.
  void update();

  /// Starts a fit of the selected probe, or stops the one under way.
  void fit();
  bool running() const { return running_; }
  /// As one undo step, with the faces that are ticked.
  void apply();
  void discard();

 signals:
  /// The box that apply() would set; nothing: none is under review.
  void ghostChanged(const std::optional<boxprobe::Probe>& ghost);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  void end(std::optional<BoxFit> result, const QString& error);
  void stop();
  Probe proposed() const;
  void refresh();

  Editor& editor_;
  std::vector<std::shared_ptr<const Model>> models_;
  QPushButton *fit_, *apply_, *discard_;
  QLabel *errors_, *remarks_;
  QWidget* review_;
  std::array<QCheckBox*, kFaces> faces_{};
  std::optional<Probe> given_;  ///< what is fitted, or was
  std::optional<BoxFit> result_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  std::atomic<int> percent_{0};
  bool running_ = false;
};

}  // namespace boxprobe
