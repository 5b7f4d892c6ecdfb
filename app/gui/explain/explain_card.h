// The card that explains a pixel: the calculation typeset, and the cubemap with what was fetched. Shown beside the
// picture; called by the debug view. Sets what it is given, computes nothing of it. Above both stands the verdict, with
// the edit that it proposes as a button.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "filters/core/picture/baked_probe.h"
#include "filters/explain/explanation.h"
#include "filters/explain/explanation_sections.h"
#include "filters/explain/verdict.h"
#include "filters/math/shared/display_math.h"

class QLabel;
class QPushButton;
class QTextBrowser;
class QToolButton;

namespace boxprobe {

class FootprintView;

class ExplainCard : public QWidget {
  Q_OBJECT

 public:
  /// The maps a probe shows now, by its name; null while it has none.
  using MapsOf = std::function<std::shared_ptr<const BakedMaps>(const std::string&)>;

  explicit ExplainCard(MapsOf mapsOf, QWidget* parent = nullptr);

  /// While the card is hidden it only remembers what to show.
  void show(const Explanation& explanation, const Verdict& verdict, double exposure, Tone tone = Tone::None);
  /// Nothing is explained; `hint` says how to.
  void showHint(const QString& hint);
  void setPinned(bool pinned);

  bool empty() const { return !explanation_; }
  void copyText() const;
  void copyJson() const;
  QString text() const;  ///< as shown, without its layout

 signals:
  void unpinRequested();
  void mendRequested(const boxprobe::Mend& mend);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fill();
  void showVerdict();
  ExplanationDetail detail() const;

  MapsOf mapsOf_;
  QLabel* state_;
  QToolButton* follow_;
  QToolButton* copyText_;
  QToolButton* copyJson_;
  QLabel* sentence_;
  QPushButton* mend_;
  QTextBrowser* text_;
  FootprintView* footprint_;
  std::optional<Explanation> explanation_;
  Verdict verdict_;
  double exposure_ = 1.0;
  Tone tone_ = Tone::None;
  bool stale_ = false;
};

}  // namespace boxprobe
