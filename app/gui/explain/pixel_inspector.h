// Which pixel is explained, and when: the one under the pointer while the tool is on, or the one that a click pinned,
// as it was seen from there: the camera can then go round and look at its rays from the side. However often something
// changes in one turn of the event loop, a pixel is explained at most once in it; switched off, nothing ever is. Called
// by the debug view; knows the renderer and the window only as functions.
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <optional>

#include "filters/explain/explanation.h"

namespace boxprobe {

class PixelInspector : public QObject {
  Q_OBJECT

 public:
  using Explain = std::function<Explanation()>;
  struct Hooks {
    std::function<bool()> ready;  ///< something can be explained now
    /// Of the pixel at a logical position: explains it as it is seen now, however the camera moves later.
    std::function<Explain(const QPointF&)> hold;
    std::function<Explanation(const QPointF&)> explain;  ///< the same, once and now
  };

  explicit PixelInspector(Hooks hooks, QObject* parent = nullptr);

  /// The tool: what is under the pointer, or pinned, is told by `explained`.
  void setTool(bool on);
  bool tool() const { return tool_; }
  /// A number is wanted under the pointer even while the tool is off.
  void setReadout(bool on);

  void pointerMoved(const QPointF& position);
  /// What was explained last stays, and stays live: the way to the card leads out of the picture.
  void pointerLeft();
  /// Pins what is there. Does nothing while the tool is off.
  void click(const QPointF& position);
  void unpin();
  bool pinned() const { return static_cast<bool>(pin_); }

  /// The scene or the maps changed.
  void invalidate();
  /// Something else is under the pointer.
  void cameraMoved();
  /// Whatever is due, now: called before a picture is drawn, so that it shows what is explained.
  void update();

  std::uint64_t explanations() const { return count_; }  ///< pixels so far

 signals:
  void explained(const boxprobe::Explanation& explanation);
  void nothingExplained();  ///< the tool went off
  void readout(const boxprobe::Explanation& explanation, const QPointF& position);
  void readoutEnded();
  void clicked(const boxprobe::Explanation& explanation);
  void pinChanged(bool pinned);

 private:
  bool wanted() const { return tool_ || readout_; }
  void schedule();
  Explanation explain(const Explain& how);

  Hooks hooks_;
  QTimer timer_;
  bool tool_ = false, readout_ = false;
  std::optional<QPointF> pointer_;  ///< where it was last
  bool inside_ = false;             ///< it still is
  Explain pin_;                     ///< empty: none
  bool pointerStale_ = false, pinStale_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace boxprobe
