// A ray-traced reference of a view, made in a thread of its own: coarse at once, finer with each pass. Called by the
// comparisons; draws nothing.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/reference/light/capture_light.h"
#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

/// What is traced.
enum class TracedLight {
  All,         ///< by reference-path: every bounce that the scene's probes have, shadows, all lights
  Diffuse,     ///< diffuse light alone, as many bounces; see PathQuantity::DiffuseLight
  Reflection,  ///< by reference-scene: the picture's own light, and the reflection alone traced
};

class ReferenceTrace : public QObject {
  Q_OBJECT

 public:
  explicit ReferenceTrace(QObject* parent = nullptr) : QObject(parent) {}
  /// Stops what is under way and waits for it.
  ~ReferenceTrace() override;

  /// Begins anew; `models` in the order of scene.models, `size` in pixels. `diffuse`: the picture's, for
  /// TracedLight::Reflection.
  void start(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models, const Camera& camera,
             const QSize& size, TracedLight light = TracedLight::All, ProbesDiffuse diffuse = {});
  /// Asks it to stop; what comes in until end() or start() is still told.
  void requestStop();
  /// Asks it to stop; nothing is told any more. Does not wait: the thread ends by itself.
  void end();
  bool running() const { return run_ != nullptr; }

 signals:
  /// A pass is done: display colours, of the size asked for; `share` of the work, 1 with the last pass. `light`: the
  /// same, linear; null while the picture is coarser than that size, unless it is diffuse light.
  void traced(const QImage& picture, double share, const std::shared_ptr<const ReferencePicture>& light);
  void failed(const QString& line);

 private:
  struct Run {
    std::thread thread;
    std::atomic<bool> stop{false}, left{false};  ///< left: its thread does nothing more
  };
  using Light = std::shared_ptr<const ReferencePicture>;
  void passDone(const QImage& picture, double share, const Light& light, const QString& error, int number);
  void forgetEnded();

  std::mutex preparing_;  ///< held by the run that builds its scene
  std::unique_ptr<Run> run_;
  int number_ = 0;                            ///< of the run that what comes in belongs to
  std::vector<std::unique_ptr<Run>> ending_;  ///< asked to stop
};

}  // namespace boxprobe
