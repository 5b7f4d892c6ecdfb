// Which pixel is explained, and when: the one under the pointer while the tool is on, or the surface point that a click
// pinned, wherever the camera has moved it since. However often something changes in one turn of the event loop, each
// pixel is explained at most once in it; switched off, nothing is ever explained. Called by the debug view; knows the
// renderer and the window only as functions.
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <optional>

#include "filters/core/explanation.h"

namespace boxprobe {

class PixelInspector : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> ready;                                               ///< something can be explained now
    std::function<Explanation(const QPointF&)> explain;                        ///< of the pixel at a logical position
    std::function<std::optional<QPointF>(const glm::dvec3&)> logicalPosition;  ///< of a point in the world, if in view
  };

  explicit PixelInspector(Hooks hooks, QObject* parent = nullptr);

  /// The tool: what is under the pointer, or pinned, is told by `explained`.
  void setTool(bool on);
  bool tool() const { return tool_; }
  /// A number is wanted under the pointer even while the tool is off.
  void setReadout(bool on);

  void pointerMoved(const QPointF& position);
  void pointerLeft();
  /// Pins what is there. Does nothing while the tool is off.
  void click(const QPointF& position);
  void unpin();
  bool pinned() const { return pin_.has_value(); }

  /// The scene, the camera or the maps changed.
  void invalidate();
  /// Whatever is due, now: called before a picture is drawn, so that it shows what is explained.
  void update();

  std::uint64_t explanations() const { return count_; }  ///< pixels so far

 signals:
  void explained(const boxprobe::Explanation& explanation);
  void nothingExplained();  ///< the pointer left, or the tool went off
  void readout(const boxprobe::Explanation& explanation, const QPointF& position);
  void readoutEnded();
  void clicked(const boxprobe::Explanation& explanation);
  void pinChanged(bool pinned);

 private:
  struct Pin {
    QPointF position;
    std::optional<glm::dvec3> pointWorld;  ///< none on the background
  };

  bool wanted() const { return tool_ || readout_; }
  std::optional<QPointF> pinPosition() const;
  Explanation explain(const QPointF& position);

  Hooks hooks_;
  QTimer timer_;
  bool tool_ = false, readout_ = false;
  std::optional<QPointF> pointer_;
  std::optional<Pin> pin_;
  bool stale_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace boxprobe
