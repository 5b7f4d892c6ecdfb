// The picture in the window against another of the same view: one that was held before something was changed, or the
// ray-traced reference, which is made in the background and gets finer. Shows it, or the difference in false colours,
// through the wipe, with the difference as a number. Called by the main window; knows the renderer only as a function.
#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/view/reference_trace.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"

namespace boxprobe {

class CompareWipe;

class PictureCompare : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> ready;                    ///< the picture is at rest and can be drawn
    std::function<QImage()> picture;                ///< as it is now, without handles; draws, but tells nobody
    std::function<ImageRgbaF(const QSize&)> light;  ///< the same, linear, of so many pixels
    std::function<Camera()> camera;                 ///< it is seen from
    std::function<std::vector<std::shared_ptr<const Model>>()> models;
    std::function<ProbesDiffuse()> diffuse;  ///< of the probes as they are shown
  };
  /// `wipe` must outlive this.
  PictureCompare(const Document& document, CompareWipe& wipe, Hooks hooks, QObject* parent = nullptr);

  /// What is on show now stands on the right from now on.
  void hold();
  /// A ray-traced reference of this view stands on the right; begun anew when the view changes.
  void traceReference(TracedLight light = TracedLight::All);
  /// All light traced, shown as the difference of both pictures in false colours.
  void traceError();
  /// In place of the other picture its difference from the one on show, in false colours with a scale.
  void setDifference(bool on);
  bool difference() const { return difference_; }
  void stop();
  bool active() const { return source_ != Source::None; }
  bool tracing() const { return trace_.running(); }
  void setFlipped(bool flipped);

  /// A picture was drawn, the document was edited.
  void pictureDrawn();
  void documentChanged();

 signals:
  void activeChanged(bool active);
  void differenceChanged(bool on);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  enum class Source { None, Held, Reference };
  void start();
  void referenceDone(const QImage& image, double share, const std::shared_ptr<const ReferencePicture>& light);
  QString lightNumbers() const;
  void measure();
  void showOther();
  QString referenceName() const;
  bool sameView() const;

  const Document& document_;
  CompareWipe& wipe_;
  Hooks hooks_;
  Source source_ = Source::None;
  QImage other_;
  QString name_;                                        ///< of `other_`
  std::shared_ptr<const ReferencePicture> otherLight_;  ///< of `other_`, once it is traced as fine as the picture
  bool difference_ = false;
  Camera camera_;  ///< of `other_`
  QSize size_;
  QTimer rest_;
  ReferenceTrace trace_;
  TracedLight light_ = TracedLight::All;  ///< of the reference
  bool traced_ = false;                   ///< a first pass of the reference is there
  bool measured_ = false;
  bool outdated_ = false;  ///< the scene was edited since the reference was begun
};

}  // namespace boxprobe
