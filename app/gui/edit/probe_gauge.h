// The error of the selected probe's box as it stands, kept up while it is edited: measured in a thread of its own, one
// at a time and the newest next, from rays that are followed again only when something moved that they meet. Called by
// the fit panel and by the handles, which show it; the mathematics is filters/fit's.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"
#include "filters/fit/box/box_gauge.h"

namespace boxprobe {

class ProbeGauge : public QObject {
  Q_OBJECT

 public:
  explicit ProbeGauge(Editor& editor, QObject* parent = nullptr);
  ~ProbeGauge() override;

  /// In the order of scene.models.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  /// Off: nothing is measured and nothing is known.
  void setOn(bool on);
  bool on() const { return on_; }
  /// For a while nothing is measured, whatever the user chose.
  void setQuiet(bool quiet);
  /// The document changed.
  void update();

  /// As last measured. While the probe is dragged it may be one measurement behind.
  const std::optional<BoxGauge>& gauge() const { return gauge_; }
  /// It is that of the probe as it stands now.
  bool current() const;
  bool running() const { return work_.running(); }

  /// Moves one face of the selected probe to where its gauge says, as one undo step. Nothing unless current().
  void snap(int face);

  struct Counts {
    std::size_t structures = 0, rays = 0, boxes = 0;  ///< built, followed, measured
  };
  const Counts& counts() const { return counts_; }

 signals:
  void changed();
  /// What is known is no longer that of the probe as it stands; a measurement follows.
  void outdated();
  void message(const QString& text);

 private:
  struct Kept;
  void start();
  void forget();

  Editor& editor_;
  std::vector<std::shared_ptr<const Model>> models_;
  bool on_ = true, quiet_ = false;
  bool measures() const { return on_ && !quiet_; }
  QTimer rest_;
  std::shared_ptr<Kept> kept_;     ///< the thread's while it runs
  std::optional<Probe> asked_;     ///< what is measured
  std::optional<Probe> measured_;  ///< what gauge_ is of
  std::optional<BoxGauge> gauge_;
  Counts counts_;
  bool outdated_ = false;  ///< something changed since the measurement under way was begun
  BackgroundWork work_;    ///< last: it ends before what it would tell of it
};

}  // namespace boxprobe
