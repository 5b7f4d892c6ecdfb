// File, Export probes: what the window's probes show, written for an engine. Pictures are read back at once; filtering
// and writing are another thread's, so that the window stays usable. Called by the menu.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <thread>

#include "filters/io/engines/probe_export.h"

class QWidget;

namespace boxprobe {

class Document;
class SceneRenderer;

class ProbeExporter : public QObject {
  Q_OBJECT

 public:
  ProbeExporter(const Document& document, SceneRenderer& renderer, QWidget* window);
  /// Stops after the probe at work.
  ~ProbeExporter() override;

  /// Asks for the engine and a folder, then exports.
  void ask();
  /// Probes without a finished capture are left out and named.
  void start(const ExportSettings& settings, const QString& folder);
  bool running() const { return running_; }

 signals:
  /// The renderer must draw the document's scene when this returns.
  void ownSceneWanted();
  void message(const QString& text);
  void failed(const QString& text);

 private:
  void end(const QString& text, bool good);

  const Document& document_;
  SceneRenderer& renderer_;
  QWidget* window_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  bool running_ = false;
};

}  // namespace boxprobe
